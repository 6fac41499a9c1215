import { AT_REST, type Answer, type Controls, type Seat } from '../game.ts';
import { nowMsOf, type HuntState } from './hunt-state.ts';

/** So long a bot looks at its photo, milliseconds. */
const LOOKS_MS = 700;

/** Finds each thing after another while, and takes a wrong photo first now and then. */
export function huntBot(state: HuntState, seat: Seat): Controls {
  const { hunt, hunted } = state;
  if (!hunt) return AT_REST;
  const nowMs = nowMsOf(state);
  const count = hunted.length;
  const share = 0.2 + ((seat * 37 + count * 61) % 97) / 125;
  const findsAtMs = hunt.beganAtMs + share * (hunt.endsAtMs - hunt.beganAtMs);
  const errsAtMs = findsAtMs - 3000;
  const score = 0.55 + ((seat * 13 + count * 29) % 40) / 100;
  const isErring = (seat + count) % 3 === 0 && errsAtMs > hunt.beganAtMs;
  if (nowMs >= findsAtMs) return answering(nowMs, { text: hunt.label, score, atMs: findsAtMs });
  if (isErring && nowMs >= errsAtMs)
    return answering(nowMs, { text: 'person', score, atMs: errsAtMs });
  return AT_REST;
}

function answering(nowMs: number, answer: Answer): Controls {
  const text = nowMs < answer.atMs + LOOKS_MS ? '' : answer.text;
  return { ...AT_REST, answer: { ...answer, text } };
}
