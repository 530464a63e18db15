// SPDX-License-Identifier: Apache-2.0
#version 330 core
in float height;
uniform vec3 top;
uniform vec3 bottom;
out vec4 fragment;

void main() {
    // A little noise hides the bands of a slow gradient.
    float grain = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - 0.5;
    fragment = vec4(mix(bottom, top, smoothstep(0.0, 1.0, height)) + grain / 255.0, 1.0);
}
