import { eventKey } from '@ubii/pm-sandbox';
import { ModuleEventKind, type ModuleEvent } from '@ubii/proto';
import type { MarkedState } from '../../ui/UiStateMark.vue';

/** Filter of events. */
export type EventFilter = 'all' | 'problems' | 'log';

/** Text and style of an event. */
export interface EventLook {
  readonly word: string;
  readonly tone: 'err' | 'warn' | 'plain';
}

/** Most events kept; older ones are dropped. */
export const MAX_EVENTS = 500;

const LOOKS: Readonly<Record<ModuleEventKind, EventLook>> = {
  [ModuleEventKind.ERROR]: { word: 'error', tone: 'err' },
  [ModuleEventKind.LOG]: { word: 'log', tone: 'plain' },
  [ModuleEventKind.KILLED]: { word: 'killed', tone: 'err' },
  [ModuleEventKind.RESTARTED]: { word: 'restarted', tone: 'warn' },
  [ModuleEventKind.FAILED]: { word: 'gave up', tone: 'err' },
  [ModuleEventKind.REFUSED]: { word: 'refused', tone: 'warn' },
  [ModuleEventKind.OVERRUN]: { word: 'overrun', tone: 'warn' },
};

const LEVELS: Readonly<Record<string, EventLook>> = {
  error: { word: 'error', tone: 'err' },
  warn: { word: 'warn', tone: 'warn' },
};

export function eventLook({ kind, level }: Pick<ModuleEvent, 'kind' | 'level'>): EventLook {
  if (kind !== ModuleEventKind.LOG) return LOOKS[kind] ?? LOOKS[ModuleEventKind.LOG];
  return LEVELS[level] ?? { word: level || 'log', tone: 'plain' };
}

export const EVENT_MARKS: Readonly<Record<EventLook['tone'], MarkedState | undefined>> = {
  err: 'error',
  warn: 'warning',
  plain: undefined,
};

/** Appends an event, within the limit. */
export function withEvent(
  events: readonly ModuleEvent[],
  more: readonly ModuleEvent[],
): readonly ModuleEvent[] {
  return [...events, ...more].slice(-MAX_EVENTS);
}

/** Newest first. @param moduleId of one module; empty for all */
export function filterEvents(
  events: readonly ModuleEvent[],
  filter: EventFilter,
  moduleId: string,
): ModuleEvent[] {
  return events
    .filter((event) => moduleId === '' || event.moduleId === moduleId)
    .filter((event) => {
      if (filter === 'all') return true;
      return (filter === 'log') === (event.kind === ModuleEventKind.LOG);
    })
    .reverse();
}

/** Group of equal events. */
export interface EventGroup {
  readonly key: string;
  readonly event: ModuleEvent;
  /** Epoch milliseconds. */
  readonly firstMs: number;
  readonly count: number;
}

/**
 * Groups equal events: a problem once, at its newest time; equal log lines if consecutive.
 *
 * @param events newest first
 */
export function groupEvents(events: readonly ModuleEvent[]): EventGroup[] {
  const groups: Mutable<EventGroup>[] = [];
  const problems = new Map<string, Mutable<EventGroup>>();
  for (const event of events) {
    const isLog = event.kind === ModuleEventKind.LOG;
    const key = `${event.moduleId} ${eventKey(event)}`;
    const last = groups.at(-1);
    const same = isLog ? (last?.key === key ? last : undefined) : problems.get(key);
    if (same !== undefined) {
      same.count += 1 + event.suppressed;
      same.firstMs = event.timeMs;
      continue;
    }
    const group = { key, event, firstMs: event.timeMs, count: 1 + event.suppressed };
    groups.push(group);
    if (!isLog) problems.set(key, group);
  }
  return groups;
}

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

const CAUSES: ReadonlySet<ModuleEventKind> = new Set([
  ModuleEventKind.ERROR,
  ModuleEventKind.KILLED,
  ModuleEventKind.REFUSED,
]);

/** Time during which an error of a run counts as current, milliseconds. */
const RECENT_MS = 10_000;

/**
 * Returns the first cause of a module's problems: of the current ones, the one that started first.
 *
 * @param events oldest first
 * @param nowMs epoch milliseconds of the master's clock; default: all problems count as current
 */
export function firstCause(
  events: readonly ModuleEvent[],
  moduleId: string,
  nowMs?: number,
): EventGroup | undefined {
  const causes = events.filter((one) => one.moduleId === moduleId && CAUSES.has(one.kind));
  return groupEvents(causes.reverse())
    .filter(({ event }) => nowMs === undefined || nowMs - event.timeMs < RECENT_MS)
    .reverse()
    .sort((a, b) => a.firstMs - b.firstMs)[0];
}

/** Returns the position in the code: `onProcessing:7:12`; empty when unknown. */
export function eventPlace({ phase, line, column }: ModuleEvent): string {
  if (phase === '') return '';
  if (line === 0) return phase;
  return column === 0 ? `${phase}:${line}` : `${phase}:${line}:${column}`;
}
