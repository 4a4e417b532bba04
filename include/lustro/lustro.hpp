// Lustro: lights and shades triangle meshes on the CPU. This header is the whole public face.
#pragma once

#include "lustro/approximation.hpp"
#include "lustro/image.hpp"
#include "lustro/material.hpp"
#include "lustro/mesh.hpp"
#include "lustro/mesh_file.hpp"
#include "lustro/options.hpp"
#include "lustro/render.hpp"
#include "lustro/result.hpp"
#include "lustro/scene.hpp"
#include "lustro/texture.hpp"
#include "lustro/vec.hpp"
#include "lustro/version.hpp"
