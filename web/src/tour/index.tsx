// The tour's places on the page: a button in the header, pins over the picture, and what floats: the card and the list of lessons.
import { lazily } from "../explain/lazy";
import { Icon } from "../layout/icons";
import { register } from "../state/slots";
import { Pins } from "./pins";
import { isListOpen, place, watchScene, watchTasks } from "./player";
import { say } from "./words";
import "./tour.css";

const Card = lazily(() => import("./card"));
const List = lazily(() => import("./list"));

function TourButton() {
  const text = say.value("tour");
  return (
    <button
      class="tool"
      type="button"
      title={say.value("title")}
      aria-haspopup="dialog"
      aria-expanded={isListOpen.value}
      data-testid="tour"
      onClick={() => (isListOpen.value = true)}
    >
      <Icon name="tour" />
      <span class="label">{text}</span>
    </button>
  );
}

function Floating() {
  return (
    <>
      {place.value ? <Card /> : null}
      {isListOpen.value ? <List /> : null}
    </>
  );
}

register("header", { id: "tour", order: 90, component: TourButton });
register("overlay", { id: "tour-pins", order: 80, component: Pins });
register("floating", { id: "tour", order: 10, component: Floating });
watchTasks();
watchScene();
