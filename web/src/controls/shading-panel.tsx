// How surfaces are lit: model and interpolation in large, then normals and faces, the parts of the sum, and the edges.
import { words } from "../i18n";
import { at } from "../state/scene";
import { Group } from "./group";
import { OptionField } from "./option-field";
import { ThumbnailView } from "./thumbnail";

const lighting = at<string>("shading.lighting");
const interpolation = at<string>("shading.interpolation");

const kLightingPictures = Object.fromEntries(
  ["constant", "lambert", "phong", "blinn-phong", "ggx"].map((word) => [word, <ThumbnailView name={`lighting/${word}`} />]),
);
const kInterpolationPictures = Object.fromEntries(
  ["flat", "gouraud", "phong"].map((word) => [word, <ThumbnailView name={`interpolation/${word}`} />]),
);

export function ShadingPanel() {
  const t = words.value.shading;
  const isPhong = (interpolation.value ?? "phong") === "phong";
  const isFlat = interpolation.value === "flat";
  const hasHighlight = lighting.value !== "constant" && lighting.value !== "lambert";
  return (
    <>
      <OptionField name="shading.lighting" pictures={kLightingPictures} />
      <OptionField name="shading.interpolation" pictures={kInterpolationPictures} />
      <Group title={t.equation}>
        <OptionField name="shading.terms" />
        <OptionField name="shading.normalized" idle={hasHighlight ? undefined : t.needsHighlight} />
      </Group>
      <Group title={t.surface}>
        <OptionField name="shading.normals" idle={isPhong ? undefined : t.needsPhong} />
        <OptionField name="shading.vertex_normals" idle={isFlat ? t.flatHasNone : undefined} />
        <OptionField name="shading.crease" implied={180} idle={isFlat ? t.flatHasNone : undefined} />
        <OptionField name="shading.recompute_normals" idle={isFlat ? t.flatHasNone : undefined} />
        <OptionField name="shading.two_sided" />
        <OptionField name="shading.cull" />
      </Group>
      <Group title={t.quality}>
        <OptionField name="image.samples" />
      </Group>
    </>
  );
}
