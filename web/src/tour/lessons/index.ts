// The lessons in their order.
import type { Lesson } from "../lesson";
import { ambient } from "./ambient";
import { blinnPhong } from "./blinn-phong";
import { edges } from "./edges";
import { exponent } from "./exponent";
import { interpolation } from "./interpolation";
import { lambert } from "./lambert";
import { lights } from "./lights";
import { phong } from "./phong";

export const lessons: readonly Lesson[] = [ambient, lambert, phong, exponent, blinnPhong, interpolation, edges, lights];
