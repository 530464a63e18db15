// SPDX-License-Identifier: Apache-2.0
#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;
layout(location = 4) in float cavity;
layout(location = 5) in vec4 tint;

uniform mat4 view;
uniform mat4 projection;
uniform vec3 cutNormal;
uniform float cutOffset;

out vec3 eyePosition;
out vec3 eyeNormal;
out vec3 vertexColour;
out vec2 pictureAt;
out float fold;
out vec4 cover;
out float cutDistance;

void main() {
    vec4 eye = view * vec4(position, 1.0);
    eyePosition = eye.xyz;
    eyeNormal = mat3(view) * normal;
    vertexColour = colour;
    pictureAt = uv;
    fold = cavity;
    cover = tint;
    cutDistance = dot(cutNormal, position) - cutOffset;
    gl_Position = projection * eye;
}
