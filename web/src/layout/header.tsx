// The page's header: its name, what opens and exports, undo, language and theme. Other folders add buttons to the slot `header`.
import { words } from "../i18n";
import { canRedo, canUndo, redo, undo } from "../state/scene";
import { language, showsHelp, theme, type Theme } from "../state/settings";
import { entriesOf } from "../state/slots";
import { IconButton } from "./icon-button";
import { Logo } from "./logo";

const kNextTheme: Record<Theme, Theme> = { system: "light", light: "dark", dark: "system" };

function ThemeButton() {
  const t = words.value;
  const text = `${t.header.theme}: ${t.themes[theme.value]}`;
  return <IconButton icon={theme.value} label={text} testid="theme" onClick={() => (theme.value = kNextTheme[theme.value])} />;
}

function LanguageButton() {
  const other = language.value === "en" ? "it" : "en";
  return (
    <button
      class="tool text"
      type="button"
      title={words.value.header.language}
      aria-label={`${words.value.header.language}: ${other === "it" ? "Italiano" : "English"}`}
      data-testid="language"
      onClick={() => (language.value = other)}
    >
      {other.toUpperCase()}
    </button>
  );
}

export function Header() {
  const t = words.value;
  return (
    <header class="header">
      <h1 class="brand">
        <Logo />
        <span>{t.title}</span>
      </h1>
      <nav class="header-tools">
        {entriesOf("header").map(({ id, component: Component }) => (
          <Component key={id} />
        ))}
      </nav>
      <div class="header-tools end">
        <IconButton icon="undo" label={t.header.undo} isDisabled={!canUndo.value} testid="undo" onClick={undo} />
        <IconButton icon="redo" label={t.header.redo} isDisabled={!canRedo.value} testid="redo" onClick={redo} />
        <IconButton
          icon="help"
          label={t.panel.showHelp}
          isPressed={showsHelp.value === "on"}
          testid="show-help"
          onClick={() => (showsHelp.value = showsHelp.value === "on" ? "off" : "on")}
        />
        <LanguageButton />
        <ThemeButton />
      </div>
    </header>
  );
}
