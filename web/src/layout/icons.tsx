// The page's icons: strokes on a grid of 20, in the colour of the text beside them.
import type { ComponentChildren } from "preact";

const kShapes = {
  open: (
    <path d="M3 6.5V15a1.5 1.5 0 0 0 1.5 1.5h11A1.5 1.5 0 0 0 17 15V8a1.5 1.5 0 0 0-1.5-1.5h-5L8.8 4.4A1.5 1.5 0 0 0 7.6 3.9H4.5A1.5 1.5 0 0 0 3 5.4z" />
  ),
  export: <path d="M10 3v9m0 0 3.5-3.5M10 12 6.5 8.5M4 13.5V16h12v-2.5" />,
  share: <path d="M8.5 11.5a3 3 0 0 0 4.2 0l3-3a3 3 0 0 0-4.2-4.2l-.9.9M11.5 8.5a3 3 0 0 0-4.2 0l-3 3a3 3 0 0 0 4.2 4.2l.9-.9" />,
  examples: <path d="M3.5 3.5h5v5h-5zM11.5 3.5h5v5h-5zM3.5 11.5h5v5h-5zM14 11.5a2.5 2.5 0 1 1 0 5 2.5 2.5 0 0 1 0-5z" />,
  undo: <path d="M7 4 3.5 7.5 7 11M4 7.5h7.5a4.5 4.5 0 0 1 0 9H8" />,
  redo: <path d="M13 4l3.5 3.5L13 11M16 7.5H8.5a4.5 4.5 0 0 0 0 9H12" />,
  light: (
    <path d="M10 6.5a3.5 3.5 0 1 1 0 7 3.5 3.5 0 0 1 0-7zM10 2v1.8M10 16.2V18M2 10h1.8M16.2 10H18M4.3 4.3l1.3 1.3M14.4 14.4l1.3 1.3M4.3 15.7l1.3-1.3M14.4 5.6l1.3-1.3" />
  ),
  dark: <path d="M16.5 11.8A6.8 6.8 0 0 1 8.2 3.5a6.8 6.8 0 1 0 8.3 8.3z" />,
  system: <path d="M3 4.5h14v9.2H3zM7.5 16.8h5M10 13.7v3" />,
  frame: <path d="M3.5 7V3.5H7M13 3.5h3.5V7M16.5 13v3.5H13M7 16.5H3.5V13M7.2 10a2.8 2.8 0 1 0 5.6 0 2.8 2.8 0 0 0-5.6 0z" />,
  close: <path d="m5 5 10 10M15 5 5 15" />,
  help: <path d="M10 2.8a7.2 7.2 0 1 1 0 14.4 7.2 7.2 0 0 1 0-14.4zM7.9 8a2.1 2.1 0 1 1 3.2 1.8c-.7.5-1.1.9-1.1 1.8M10 14v.2" />,
  reset: <path d="M4 4v4h4M4.4 8A6.2 6.2 0 1 1 4 12" />,
  add: <path d="M10 4v12M4 10h12" />,
  remove: <path d="M4 6h12M8 6V4h4v2M6 6l.7 10h6.6L14 6M8.7 9v4.5M11.3 9v4.5" />,
  copy: <path d="M7 7h9v9H7zM13 7V4H4v9h3" />,
  chevron: <path d="m6 8 4 4 4-4" />,
  pin: <path d="M10 17s5-5.2 5-8.8a5 5 0 0 0-10 0C5 11.800 10 17 10 17zM10 6.600a1.700 1.700 0 1 1 0 3.400 1.700 1.700 0 0 1 0-3.400z" />,
  more: <path d="M4.5 10h.1M10 10h.1M15.500 10h.1" />,
  settings: <path d="M3 6h8M15 6h2M3 14h2M9 14h8M13 4v4M7 12v4" />,
  pixel: <path d="M3.500 3.500h13v13h-13zM3.500 8h13M3.500 12h13M8 3.500v13M12 3.500v13" />,
  profile: <path d="M3 16.500h14M3 13c2.500 0 3-7.500 5.500-7.500S12 11 14 11s1.500-3 3-3" />,
  camera: <path d="M3 6.500h9v7.500H3zM12 9.200l5-2.400v6.900l-5-2.400" />,
  tour: (
    <path d="M10 4.500 2.500 8l7.500 3.500L17.500 8zM5.500 9.500v3.700c1.200 1.100 2.700 1.700 4.500 1.700s3.300-.6 4.500-1.700V9.500" />
  ),
} satisfies Record<string, ComponentChildren>;

export type IconName = keyof typeof kShapes;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 20 20" width="20" height="20" aria-hidden="true" focusable="false">
      {kShapes[name]}
    </svg>
  );
}
