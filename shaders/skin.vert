// SPDX-License-Identifier: Apache-2.0
#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;
layout(location = 4) in float cavity;
layout(location = 5) in vec4 tint;
layout(location = 6) in vec4 visibility;
layout(location = 7) in vec3 rest;

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
out vec4 open;
out vec3 restPlace;

void main() {
    vec4 eye = view * vec4(position, 1.0);
    eyePosition = eye.xyz;
    eyeNormal = mat3(view) * normal;
    vertexColour = colour;
    pictureAt = uv;
    fold = cavity;
    cover = tint;
    open = vec4(mat3(view) * visibility.xyz, visibility.w);
    restPlace = rest;
    cutDistance = dot(cutNormal, position) - cutOffset;
    gl_Position = projection * eye;
}
