// SPDX-License-Identifier: Apache-2.0
#version 330 core
in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 vertexColour;
in vec2 pictureAt;
in float fold;
in vec4 cover;
in float cutDistance;

uniform vec3 plainColour;
uniform bool hasColours;
uniform bool hasTexture;
uniform sampler2D picture;
uniform float opacity;
uniform bool isCut;
uniform float gloss;
uniform float softness;
uniform bool clinical;

out vec4 fragment;

// Light that comes from `direction`, a part of which wanders under the skin and comes out where
// the surface already turns away: the red goes furthest.
vec3 softDiffuse(vec3 n, vec3 direction) {
    float facing = dot(n, direction);
    vec3 wrap = softness * vec3(0.34, 0.17, 0.12);
    vec3 lit = clamp((vec3(facing) + wrap) / (1.0 + wrap), 0.0, 1.0);
    return lit * mix(vec3(1.0), lit, 0.35);
}

float highlight(vec3 n, vec3 toEye, vec3 direction, float sharpness) {
    vec3 halfway = normalize(direction + toEye);
    float fresnel = 0.035 + 0.55 * pow(1.0 - max(dot(halfway, toEye), 0.0), 5.0);
    return fresnel * (sharpness + 2.0) / 8.0 * pow(max(dot(n, halfway), 0.0), sharpness) *
           max(dot(n, direction), 0.0);
}

void main() {
    if (isCut && cutDistance > 0.0) {
        discard;
    }
    vec3 n = normalize(eyeNormal);
    vec3 toEye = normalize(-eyePosition);
    bool inside = !gl_FrontFacing;
    if (inside) {
        n = -n;
    }
    vec3 base = hasTexture ? texture(picture, pictureAt).rgb
                           : pow(hasColours ? vertexColour : plainColour, vec3(2.2));

    base = mix(base, pow(max(cover.rgb / max(cover.a, 1e-4), 0.0), vec3(2.2)), cover.a);

    // A portrait studio: large key light from above left, weak fill from the right, rim behind.
    const vec3 key = normalize(vec3(-0.42, 0.55, 0.72));
    const vec3 fill = normalize(vec3(0.75, 0.05, 0.55));
    const vec3 rim = normalize(vec3(0.35, 0.45, -0.82));
    vec3 light = 2.35 * vec3(1.0, 0.965, 0.92) * softDiffuse(n, key) +
                 0.62 * vec3(0.82, 0.90, 1.0) * softDiffuse(n, fill) +
                 0.75 * vec3(0.95, 0.97, 1.0) * max(dot(n, rim), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    light += mix(vec3(0.20, 0.155, 0.14), vec3(0.37, 0.40, 0.44), sky);
    if (clinical) {
        // Two even lamps beside the camera, as for clinical photographs: no side is favoured.
        light = 1.15 * (softDiffuse(n, normalize(vec3(-0.5, 0.12, 0.86))) +
                        softDiffuse(n, normalize(vec3(0.5, 0.12, 0.86)))) + vec3(0.42);
    }

    float open = 1.0 - 0.62 * fold;
    vec3 bounce = mix(vec3(1.0), vec3(0.72, 0.42, 0.36), softness * fold);
    vec3 colour = base * light * open * bounce / 3.14159 * 1.28;

    float shine = 0.75 * highlight(n, toEye, key, 18.0) + 0.35 * highlight(n, toEye, key, 55.0) +
                  0.4 * highlight(n, toEye, fill, 14.0) + 0.3 * highlight(n, toEye, rim, 12.0);
    colour += gloss * 2.2 * shine * open;
    if (inside) {
        colour *= vec3(0.22, 0.14, 0.13);
    }

    // Filmic shoulder, so that highlights keep their colour, then sRGB.
    colour = (colour * (2.51 * colour + 0.03)) / (colour * (2.43 * colour + 0.59) + 0.14);
    fragment = vec4(pow(clamp(colour, 0.0, 1.0), vec3(1.0 / 2.2)), opacity);
}
