// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/image.h"

#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <jpeglib.h>
#include <png.h>
#include <string>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

constexpr unsigned kLargestSide = 16384;

Image decode_png(const std::string& bytes, const std::string& name) {
    png_image png;
    std::memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
        throw IoError(name + ": is not a readable PNG (" + png.message + ").");
    }
    if (png.width > kLargestSide || png.height > kLargestSide) {
        png_image_free(&png);
        throw IoError(name + ": the picture is larger than 16384 pixels.");
    }
    png.format = PNG_FORMAT_RGBA;
    Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    image.rgba.resize(PNG_IMAGE_SIZE(png));
    if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0) {
        throw IoError(name + ": is not a readable PNG (" + png.message + ").");
    }
    return image;
}

struct JpegErrors {
    jpeg_error_mgr manager;  // first, so that a pointer to it is a pointer to this
    std::jmp_buf escape;
};

void escape_from_jpeg(j_common_ptr info) {
    std::longjmp(reinterpret_cast<JpegErrors*>(info->err)->escape, 1);
}

/// Plain C style throughout: longjmp must not skip a destructor. False when the data is bad.
bool decode_jpeg(const unsigned char* bytes, std::size_t size, jpeg_decompress_struct& info,
                 JpegErrors& errors, Image& image) {
    if (setjmp(errors.escape) != 0) {
        return false;
    }
    jpeg_mem_src(&info, bytes, size);
    jpeg_read_header(&info, TRUE);
    if (info.image_width > kLargestSide || info.image_height > kLargestSide) {
        return false;
    }
    info.out_color_space = JCS_EXT_RGBA;
    jpeg_start_decompress(&info);
    image.width = static_cast<int>(info.output_width);
    image.height = static_cast<int>(info.output_height);
    const std::size_t stride = 4 * static_cast<std::size_t>(image.width);
    image.rgba.resize(stride * static_cast<std::size_t>(image.height));
    while (info.output_scanline < info.output_height) {
        JSAMPROW row = image.rgba.data() + stride * info.output_scanline;
        jpeg_read_scanlines(&info, &row, 1);
    }
    jpeg_finish_decompress(&info);
    return true;
}

Image read_jpeg(const std::string& bytes, const std::string& name) {
    JpegErrors errors{};
    jpeg_decompress_struct info{};
    info.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = escape_from_jpeg;
    errors.manager.output_message = [](j_common_ptr) {};
    jpeg_create_decompress(&info);
    Image image;
    const bool good = decode_jpeg(reinterpret_cast<const unsigned char*>(bytes.data()),
                                  bytes.size(), info, errors, image);
    jpeg_destroy_decompress(&info);
    if (!good) {
        throw IoError(name + ": is not a readable JPEG.");
    }
    return image;
}

}  // namespace

Image read_image_bytes(const std::string& bytes, const std::string& name) {
    if (bytes.substr(0, 4) == "\x89PNG") {
        return decode_png(bytes, name);
    }
    if (bytes.substr(0, 2) == "\xFF\xD8") {
        return read_jpeg(bytes, name);
    }
    throw IoError(name + ": is neither PNG nor JPEG.");
}

Image read_image(const std::filesystem::path& file) {
    return read_image_bytes(read_file(file), file.string());
}

std::string encode_jpeg(const Image& image, int quality) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors;
    info.err = jpeg_std_error(&errors);  // writing to memory: only running out of it can fail
    jpeg_create_compress(&info);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;  // NOLINT: the library's own type
    jpeg_mem_dest(&info, &bytes, &size);
    info.image_width = static_cast<JDIMENSION>(image.width);
    info.image_height = static_cast<JDIMENSION>(image.height);
    info.input_components = 4;
    info.in_color_space = JCS_EXT_RGBA;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, quality, TRUE);
    jpeg_start_compress(&info, TRUE);
    const std::size_t stride = 4 * static_cast<std::size_t>(image.width);
    while (info.next_scanline < info.image_height) {
        // The library's interface is not const-correct; it only reads.
        auto* row = const_cast<JSAMPROW>(image.rgba.data() + stride * info.next_scanline);
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    std::string result(reinterpret_cast<const char*>(bytes), size);
    jpeg_destroy_compress(&info);
    std::free(bytes);
    return result;
}

void write_png(const std::filesystem::path& file, const Image& image) {
    png_image png;
    std::memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = 0;
    png_image_write_get_memory_size(png, size, 0, image.rgba.data(), 0, nullptr);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgba.data(), 0, nullptr) ==
        0) {
        throw IoError(file.string() + ": cannot be encoded as PNG.");
    }
    bytes.resize(size);
    write_file(file, bytes);
}

}  // namespace myoface
