import { useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import type { Ref } from 'vue';
import { storedAs } from '../json/read-stored.ts';
import { finite, textOrNone, validElements } from '../json/schemas.ts';

/** Something that this browser opened or ran. */
export interface RecentThing {
  /** Kind and name, as the palette calls it: `session 3f2a`, `module clock`, `page /settings`. */
  readonly id: string;
  /** Its name when it was opened; empty for what the palette ran. */
  readonly title: string;
  /** Address of its page; empty for what the palette ran. */
  readonly path: string;
  /** Epoch milliseconds. */
  readonly atMs: number;
}

/** Kinds of things with a page of their own. */
export type ThingKind = 'session' | 'example' | 'module' | 'recording' | 'panels';

/** Things kept of each kind: what is opened often does not drive out the rest. */
const MAX_OF_KIND = 6;

const THING = v.object({ id: v.string(), title: textOrNone, path: textOrNone, atMs: finite });
const STORED = storedAs<v.GenericSchema<unknown, readonly RecentThing[]>>(validElements(THING), []);

/** Pages that show a thing; the group is what distinguishes it from others of its kind. */
const PAGES: readonly (readonly [ThingKind, RegExp])[] = [
  ['session', /^\/sessions\/(?!new(?:\/|$))([^/]+)/],
  ['module', /^\/modules\/([^/]+)/],
  ['recording', /^\/recordings\/([^/]+)/],
  ['example', /^\/examples\/([^/]+)/],
  ['example', /^\/(party)$/],
  ['panels', /^\/panels()$/],
];

/** First word of an id. */
export const kindOf = ({ id }: Pick<RecentThing, 'id'>): string => id.split(' ', 1)[0] ?? '';

/** Returns the id of the thing that a page shows; `undefined` for lists and other pages. */
export function thingAt(path: string): string | undefined {
  for (const [kind, page] of PAGES) {
    const [, name] = page.exec(path) ?? [];
    if (name !== undefined) return `${kind} ${decoded(name)}`.trim();
  }
  return undefined;
}

function decoded(segment: string): string {
  try {
    return decodeURIComponent(segment);
  } catch {
    return segment;
  }
}

/** Returns the list, newest first, after a thing was opened. */
export function withRecent(things: readonly RecentThing[], thing: RecentThing): RecentThing[] {
  const counts = new Map<string, number>();
  const before = things.find(({ id }) => id === thing.id);
  // What the palette opens has been opened before, perhaps.
  const newest = thing.path === '' && before ? { ...before, atMs: thing.atMs } : thing;
  return [newest, ...things.filter((one) => one !== before)].filter((one) => {
    const count = (counts.get(kindOf(one)) ?? 0) + 1;
    counts.set(kindOf(one), count);
    return count <= MAX_OF_KIND;
  });
}

/** True in a browser that has opened neither a session nor an example. */
export const isNewcomer = (things: readonly RecentThing[]): boolean =>
  !things.some((one) => ['session', 'example'].includes(kindOf(one)));

/** What this browser used lately, newest first: the palette and Home show it. */
export function useRecent(): {
  readonly things: Readonly<Ref<readonly RecentThing[]>>;
  /** Notes that something was opened or run now. */
  note(thing: Omit<RecentThing, 'atMs'>): void;
} {
  const things = useLocalStorage<readonly RecentThing[]>('ubii.recent', [], { serializer: STORED });
  return {
    things,
    note: (thing) => (things.value = withRecent(things.value, { ...thing, atMs: Date.now() })),
  };
}
