import { defineConfig } from "vite";

export default defineConfig({
  base: "./", // the style sheet finds its fonts wherever the server mounts the folder
  publicDir: false,
  build: {
    outDir: "../static/build",
    emptyOutDir: true,
    manifest: "manifest.json",
    assetsDir: "",
    assetsInlineLimit: 0, // data: addresses are outside the content-security policy
    modulePreload: { polyfill: false },
    target: "es2022",
    cssTarget: ["chrome123", "firefox121", "safari17.5"], // the first that know light-dark()
    rolldownOptions: { input: "main.ts" },
  },
});
