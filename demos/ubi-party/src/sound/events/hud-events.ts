import type { Hud } from '../../sim/index.ts';
import type { SoundEvent } from './sound-event.ts';

/** A number that appears is heard from here. */
const COUNTED_FROM = 3;

/** Sound events of any game, derived from changes of the hud. */
export function hudEvents(before: Hud | undefined, after: Hud): SoundEvent[] {
  if (!before) return [];
  const events: SoundEvent[] = after.out
    .filter((seat) => !before.out.includes(seat))
    .map((seat) => ({ kind: 'fall', seat }));
  const { news } = after;
  const isNew = news !== undefined && news.sentence !== before.news?.sentence;
  // A fall is heard already
  if (isNew && events.length === 0) events.push({ kind: 'news', seat: news.seat });
  if (after.question !== undefined && after.question.text !== before.question?.text)
    events.push({ kind: 'question' });
  return [...events, ...tickOf(before.corner, after.corner)];
}

function tickOf(before: Hud['corner'], after: Hud['corner']): SoundEvent[] {
  const left = Number(after?.value);
  if (!after || !Number.isFinite(left) || left < 1) return [];
  const isCounting = before?.label === after.label && left < Number(before.value);
  const isFirst = before?.label !== after.label && left <= COUNTED_FROM;
  return isCounting || isFirst ? [{ kind: 'tick', left }] : [];
}
