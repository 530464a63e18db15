// SPDX-License-Identifier: Apache-2.0
#version 330 core
in vec3 markerColour;
out vec4 fragment;

void main() {
    float r = length(2.0 * gl_PointCoord - 1.0);
    float edge = fwidth(r);
    float ring = smoothstep(0.62 - edge, 0.62 + edge, r);
    float cover = 1.0 - smoothstep(1.0 - 1.5 * edge, 1.0, r);
    fragment = vec4(mix(markerColour, vec3(0.05), ring), cover);
}
