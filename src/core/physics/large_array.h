// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace myoface {

/// Plain data in zeroed memory of its own, aligned for vector instructions; large ones on large
/// pages where the system gives them.
template <typename T>
class LargeArray {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    LargeArray() = default;
    explicit LargeArray(std::size_t size) { reset(size); }

    /// New zeroed contents.
    void reset(std::size_t size) {
        constexpr std::size_t kLargePage = std::size_t{2} << 20;
        size_ = size;
        if (size == 0) {
            data_.reset();
            return;
        }
        const std::size_t bytes = size * sizeof(T);
        const std::size_t alignment = bytes >= 2 * kLargePage ? kLargePage : 64;
        const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
        void* memory = std::aligned_alloc(alignment, whole);
        if (memory == nullptr) {
            throw std::bad_alloc();
        }
#ifdef __linux__
        if (alignment == kLargePage) {
            madvise(memory, whole, MADV_HUGEPAGE);
        }
#endif
        std::memset(memory, 0, whole);
        data_.reset(static_cast<T*>(memory));
    }

    T* data() {
        return data_.get();
    }
    const T* data() const {
        return data_.get();
    }
    std::size_t size() const {
        return size_;
    }
    bool empty() const {
        return size_ == 0;
    }
    T& operator[](std::size_t i) {
        return data_.get()[i];
    }
    const T& operator[](std::size_t i) const {
        return data_.get()[i];
    }
    T* begin() {
        return data();
    }
    T* end() {
        return data() + size_;
    }
    void swap(LargeArray& other) noexcept {
        data_.swap(other.data_);
        std::swap(size_, other.size_);
    }

private:
    struct Free {
        void operator()(T* memory) const { std::free(memory); }
    };
    std::unique_ptr<T, Free> data_;
    std::size_t size_ = 0;
};

}  // namespace myoface
