import type { Session } from '@ubii/proto';
import type { RouteLocationRaw } from 'vue-router';
import { sessionLocation } from '../../locations/session-location.ts';
import { kindOf, type RecentThing, type ThingKind } from '../../page/recent.ts';
import { isWatched, sessionState, stateLook } from '../../sessions/state/session-state.ts';
import { formatClock, formatDay } from '../../ui/readouts/format-clock.ts';

/** Something that this browser opened before, to continue with. */
export interface ContinueEntry {
  readonly id: string;
  readonly kind: ThingKind;
  readonly title: string;
  /** What it is, a few words. */
  readonly fact: string;
  readonly to: RouteLocationRaw;
  readonly when: string;
}

/** Most entries. */
const MAX_ENTRIES = 5;
const DAY_MS = 86_400_000;

const KINDS: Readonly<Record<ThingKind, string>> = {
  session: 'session',
  example: 'example',
  module: 'module',
  recording: 'recording',
  panels: '',
};

/** When something was opened: `today 14:02`, `yesterday`, `2 Jan 2026`. */
export function whenOpened(atMs: number, nowMs: number): string {
  if (formatDay(atMs) === formatDay(nowMs)) return `today ${formatClock(atMs, 'minute')}`;
  return formatDay(atMs) === formatDay(nowMs - DAY_MS) ? 'yesterday' : formatDay(atMs);
}

/**
 * Returns what was opened last, newest first, without sessions that run, which have cards, and without those that are
 * gone.
 *
 * @param sessions stored ones included; `undefined` until known
 */
export function continueEntries(
  things: readonly RecentThing[],
  sessions: readonly Session[] | undefined,
  nowMs: number,
): ContinueEntry[] {
  const byId = new Map((sessions ?? []).map((session) => [`session ${session.id}`, session]));
  return things
    .filter(({ path }) => path !== '')
    .flatMap((thing): ContinueEntry[] => {
      const kind = kindOf(thing);
      if (!isKind(kind)) return [];
      const entry = {
        id: thing.id,
        kind,
        title: thing.title,
        fact: KINDS[kind],
        to: thing.path,
        when: whenOpened(thing.atMs, nowMs),
      };
      if (kind !== 'session' || sessions === undefined) return [entry];
      const session = byId.get(thing.id);
      if (session === undefined || isWatched(session)) return [];
      const { word } = stateLook(sessionState(session));
      return [
        {
          ...entry,
          title: session.name,
          fact: `session, ${word.toLowerCase()}`,
          to: sessionLocation(session.id),
        },
      ];
    })
    .slice(0, MAX_ENTRIES);
}

const isKind = (kind: string): kind is ThingKind => Object.hasOwn(KINDS, kind);
