// SPDX-License-Identifier: Apache-2.0
#version 330 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec3 colour;
uniform mat4 view;
uniform mat4 projection;
out vec3 lineColour;

void main() {
    lineColour = colour;
    gl_Position = projection * view * vec4(position, 1.0);
    gl_Position.z -= 2e-4 * gl_Position.w;  // just in front of the surface it lies on
}
