// What the page has to say, at the foot of the stage; screen readers hear it.
import { words } from "../i18n";
import { dismiss, messages, type Message } from "../state/messages";
import { IconButton } from "./icon-button";

function Entry({ message }: { message: Message }) {
  const t = words.value.messages;
  return (
    <li class={`message ${message.kind}`} data-testid={`message-${message.kind}`}>
      <p>
        <strong>{t[message.kind]}</strong> {message.text}
      </p>
      <IconButton icon="close" label={t.dismiss} isSmall onClick={() => dismiss(message.id)} />
    </li>
  );
}

export function Messages() {
  const urgent = messages.value.filter((message) => message.kind === "error");
  const calm = messages.value.filter((message) => message.kind !== "error");
  return (
    <section class="messages" aria-label={words.value.messages.label}>
      <ul aria-live="assertive">
        {urgent.map((message) => (
          <Entry key={message.id} message={message} />
        ))}
      </ul>
      <ul aria-live="polite">
        {calm.map((message) => (
          <Entry key={message.id} message={message} />
        ))}
      </ul>
    </section>
  );
}
