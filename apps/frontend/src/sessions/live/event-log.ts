import { ModuleEventKind, type ModuleEvent } from '@ubii/proto';
import type { MarkedState } from '../../ui/UiStateMark.vue';

/** Which events are shown. */
export type EventFilter = 'all' | 'problems' | 'log';

/** How an event looks. */
export interface EventLook {
  readonly word: string;
  readonly tone: 'err' | 'warn' | 'plain';
}

/** Events kept; older ones are forgotten. */
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

/** The events with another one, newest last, no more than are kept. */
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

/** `12:41:07.218`, of this machine's time zone. */
export function clockTime(timeMs: number): string {
  const time = new Date(timeMs);
  const two = (value: number): string => String(value).padStart(2, '0');
  const ms = String(time.getMilliseconds()).padStart(3, '0');
  return `${two(time.getHours())}:${two(time.getMinutes())}:${two(time.getSeconds())}.${ms}`;
}

/** Where in the code it happened: `onProcessing:7:12`; empty when nobody knows. */
export function eventPlace({ phase, line, column }: ModuleEvent): string {
  if (phase === '') return '';
  if (line === 0) return phase;
  return column === 0 ? `${phase}:${line}` : `${phase}:${line}:${column}`;
}
