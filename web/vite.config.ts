// How the page is built: static files that work below any path of any web host, with a policy that lets it talk to nobody else.
import { defineConfig, type Plugin } from "vitest/config";

const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self' blob:",
  "connect-src 'self'",
  "img-src 'self' blob: data:",
  "style-src 'self' 'unsafe-inline'",
  "font-src 'self'",
  "form-action 'none'",
  "base-uri 'none'",
].join("; ");

/** The policy as a <meta> of the built page; the development server needs inline scripts of its own. */
function contentSecurityPolicy(): Plugin {
  return {
    name: "content-security-policy",
    apply: "build",
    transformIndexHtml: () => [
      { tag: "meta", attrs: { "http-equiv": "Content-Security-Policy", content: policy }, injectTo: "head-prepend" },
    ],
  };
}

/** Of KaTeX's fonts the one format that every browser of today takes; the others would be two thirds of the page's files. */
function woff2Alone(): Plugin {
  return {
    name: "woff2-alone",
    enforce: "pre",
    transform: (code, id) => (/katex.*\.css$/.test(id) ? code.replace(/,url\([^)]+\) format\("(woff|truetype)"\)/g, "") : undefined),
  };
}

export default defineConfig({
  base: "./",
  plugins: [contentSecurityPolicy(), woff2Alone()],
  worker: { format: "es" },
  build: { target: "es2022", assetsInlineLimit: 0, modulePreload: { polyfill: false }, chunkSizeWarningLimit: 600 },
  test: { include: ["tests/unit/**/*.test.{ts,tsx}"] },
});
