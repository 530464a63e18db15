// SPDX-License-Identifier: Apache-2.0
#version 330 core
in vec3 lineColour;
uniform float opacity;
out vec4 fragment;

void main() {
    fragment = vec4(lineColour, opacity);
}
