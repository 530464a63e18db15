// SPDX-License-Identifier: Apache-2.0
#version 330 core
in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 vertexColour;
in vec2 pictureAt;
in float fold;
in vec4 cover;
in float cutDistance;
in vec4 open;       // share of light that arrives from direction d: open.w + open.xyz · d
in vec3 restPlace;  // where the place is on the face at rest: patterns stay on the skin

uniform vec3 plainColour;
uniform bool hasColours;
uniform bool hasTexture;
uniform sampler2D picture;
uniform float opacity;
uniform bool isCut;
uniform float gloss;
uniform float lit;      // share of all light that gets there
uniform float softness;
uniform bool clinical;
uniform float detail;   // colour of skin that has no picture of its own: 0 none … 1
uniform float relief;   // pores, for the highlights

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
    float fresnel = 0.028 + 0.55 * pow(1.0 - max(dot(halfway, toEye), 0.0), 5.0);
    return fresnel * (sharpness + 2.0) / 8.0 * pow(max(dot(n, halfway), 0.0), sharpness) *
           max(dot(n, direction), 0.0);
}

// Light past nose, brow and chin. Under skin it wanders into the shadow's edge, the red furthest.
vec3 arriving(vec3 direction) {
    float share = smoothstep(0.0, 1.0, clamp(open.w + dot(open.xyz, direction), 0.0, 1.0));
    return mix(vec3(share), pow(vec3(share), vec3(0.62, 0.95, 1.08)), softness);
}

float hash(vec3 p) {
    p = fract(p * vec3(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yxz + 33.33);
    return fract((p.x + p.y) * p.z);
}

// Smooth noise of 0 … 1 in w and its gradient.
vec4 noise(vec3 p) {
    vec3 cell = floor(p);
    vec3 f = p - cell;
    vec3 u = f * f * (3.0 - 2.0 * f);
    vec3 du = 6.0 * f * (1.0 - f);
    float a = hash(cell);
    float b = hash(cell + vec3(1, 0, 0));
    float c = hash(cell + vec3(0, 1, 0));
    float d = hash(cell + vec3(1, 1, 0));
    float e = hash(cell + vec3(0, 0, 1));
    float g = hash(cell + vec3(1, 0, 1));
    float h = hash(cell + vec3(0, 1, 1));
    float i = hash(cell + vec3(1, 1, 1));
    float k1 = b - a;
    float k2 = c - a;
    float k3 = e - a;
    float k4 = a - b - c + d;
    float k5 = a - c - e + h;
    float k6 = a - b - e + g;
    float k7 = -a + b + c - d + e - g - h + i;
    float value = a + k1 * u.x + k2 * u.y + k3 * u.z + k4 * u.x * u.y + k5 * u.y * u.z +
                  k6 * u.z * u.x + k7 * u.x * u.y * u.z;
    return vec4(du * vec3(k1 + k4 * u.y + k6 * u.z + k7 * u.y * u.z,
                          k2 + k5 * u.z + k4 * u.x + k7 * u.z * u.x,
                          k3 + k6 * u.x + k5 * u.y + k7 * u.x * u.y),
                value);
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

    // Patterns that would be finer than the picture fade away.
    float pixel = length(fwidth(restPlace));  // [mm]
    float pores = 0.0;
    if (relief > 0.0 || detail > 0.0) {
        vec4 fine = noise(restPlace * 1.45);
        float seen = clamp(1.25 - 1.6 * pixel, 0.0, 1.0);
        pores = seen * (fine.w - 0.5);
        n = normalize(n + relief * seen * 0.16 * (fine.xyz - dot(fine.xyz, n) * n));
        if (detail > 0.0) {
            float broad = noise(restPlace * 0.055).w - 0.5;
            float small = noise(restPlace * 0.31).w - 0.5;
            float red = detail * (0.20 * broad + 0.13 * small);
            base *= vec3(1.0 + 0.45 * red, 1.0 - red, 1.0 - 0.85 * red) *
                    (1.0 + detail * (0.10 * small + 0.10 * pores));
        }
    }
    base = mix(base, pow(max(cover.rgb / max(cover.a, 1e-4), 0.0), vec3(2.2)), cover.a);

    // A portrait studio: large key light from above left, weak fill from the right, rim behind.
    const vec3 key = normalize(vec3(-0.42, 0.55, 0.72));
    const vec3 fill = normalize(vec3(0.75, 0.05, 0.55));
    const vec3 rim = normalize(vec3(0.35, 0.45, -0.82));
    const vec3 left = normalize(vec3(-0.5, 0.12, 0.86));
    const vec3 right = normalize(vec3(0.5, 0.12, 0.86));
    // What comes from all around: nothing gets into holes, and skin colours what it throws back.
    float around = clamp(open.w + 0.62 * dot(open.xyz, n), 0.0, 1.0);
    vec3 bounced = max(vec3(around), ((around * (2.04 * base - 0.33) + (-4.80 * base + 0.64)) *
                                          around + (2.76 * base + 0.69)) * around);
    vec3 ambient = mix(vec3(around), bounced, softness);
    vec3 light;
    if (clinical) {
        // Two even lamps beside the camera, as for clinical photographs: no side is favoured.
        light = 1.22 * (softDiffuse(n, left) * arriving(left) +
                        softDiffuse(n, right) * arriving(right)) + 0.46 * ambient;
    } else {
        float sky = 0.5 + 0.5 * n.y;
        light = 2.30 * vec3(1.0, 0.965, 0.92) * softDiffuse(n, key) * arriving(key) +
                0.70 * vec3(0.86, 0.92, 1.0) * softDiffuse(n, fill) * arriving(fill) +
                0.75 * vec3(0.95, 0.97, 1.0) * max(dot(n, rim), 0.0) * arriving(rim) +
                mix(vec3(0.27, 0.21, 0.19), vec3(0.46, 0.49, 0.53), sky) * ambient;
    }

    float hollow = 1.0 - 0.38 * fold;
    vec3 bounce = mix(vec3(1.0), vec3(0.80, 0.52, 0.46), softness * fold);
    vec3 colour = base * light * hollow * bounce / 3.14159 * 1.24;

    float oil = 1.0 + 1.4 * pores;
    float shine;
    if (clinical) {
        shine = 0.22 * (highlight(n, toEye, left, 16.0) * arriving(left).g +
                        highlight(n, toEye, right, 16.0) * arriving(right).g);
    } else {
        shine = (0.62 * highlight(n, toEye, key, 14.0) + 0.26 * highlight(n, toEye, key, 46.0)) *
                    arriving(key).g +
                0.34 * highlight(n, toEye, fill, 12.0) * arriving(fill).g +
                0.30 * highlight(n, toEye, rim, 10.0) * arriving(rim).g;
    }
    colour += gloss * 2.2 * shine * hollow * oil;
    colour *= lit;
    if (inside) {
        colour *= vec3(0.22, 0.14, 0.13);
    }

    // Filmic shoulder, so that highlights keep their colour, then sRGB.
    colour = (colour * (2.51 * colour + 0.03)) / (colour * (2.43 * colour + 0.59) + 0.14);
    fragment = vec4(pow(clamp(colour, 0.0, 1.0), vec3(1.0 / 2.2)), opacity);
}
