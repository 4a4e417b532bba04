// What ESLint finds that the compiler does not: unused values, promises that nobody waits for.
import tseslint from "typescript-eslint";

export default tseslint.config({ ignores: ["dist", "public", "engine", "*.config.*"] }, ...tseslint.configs.recommended, {
  languageOptions: { parserOptions: { project: "./tsconfig.json", tsconfigRootDir: import.meta.dirname } },
  rules: {
    "@typescript-eslint/no-floating-promises": "error",
    "@typescript-eslint/no-non-null-assertion": "off",
    "@typescript-eslint/no-unused-vars": ["error", { argsIgnorePattern: "^_", varsIgnorePattern: "^_" }],
    eqeqeq: "error",
  },
});
