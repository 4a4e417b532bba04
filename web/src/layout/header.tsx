// The page's header: its name, what opens and exports, undo, language and theme. Other folders add buttons to the slot `header`.
import { words } from "../i18n";
import { canRedo, canUndo, redo, undo } from "../state/scene";
import { language, showsHelp, theme, type Theme } from "../state/settings";
import { entriesOf } from "../state/slots";
import { Icon } from "./icons";
import { Logo } from "./logo";

const kNextTheme: Record<Theme, Theme> = { system: "light", light: "dark", dark: "system" };

function ThemeButton() {
  const t = words.value;
  const text = `${t.header.theme}: ${t.themes[theme.value]}`;
  return (
    <button
      class="tool"
      type="button"
      title={text}
      aria-label={text}
      data-testid="theme"
      onClick={() => (theme.value = kNextTheme[theme.value])}
    >
      <Icon name={theme.value} />
    </button>
  );
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
        <button
          class="tool"
          type="button"
          title={t.header.undo}
          aria-label={t.header.undo}
          disabled={!canUndo.value}
          data-testid="undo"
          onClick={undo}
        >
          <Icon name="undo" />
        </button>
        <button
          class="tool"
          type="button"
          title={t.header.redo}
          aria-label={t.header.redo}
          disabled={!canRedo.value}
          data-testid="redo"
          onClick={redo}
        >
          <Icon name="redo" />
        </button>
        <button
          class="tool"
          type="button"
          aria-pressed={showsHelp.value === "on"}
          title={t.panel.showHelp}
          aria-label={t.panel.showHelp}
          data-testid="show-help"
          onClick={() => (showsHelp.value = showsHelp.value === "on" ? "off" : "on")}
        >
          <Icon name="help" />
        </button>
        <LanguageButton />
        <ThemeButton />
      </div>
    </header>
  );
}
