import type { ClientActivity } from '@ubii/proto';
import { plural } from '@ubii/words';
import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { ClientView } from '../model/client-view.ts';

/** Criteria for ranking clients: share of the master's work, bytes per second, queued bytes. */
export type LoadMeasure = 'work' | 'bandwidth' | 'queue';

/** Load of a client, its cause, and a remedy. */
export interface ClientLoad {
  readonly view: ClientView;
  /** Share of the master's work, 0 to 1. */
  readonly workShare: number;
  /** Both directions, bytes per second. */
  readonly bytesPerSecond: number;
  readonly queuedBytes: number;
  /** Cause, one sentence. */
  readonly cause: string;
  /** Remedy, one sentence; empty when none is needed. */
  readonly remedy: string;
  readonly isTrouble: boolean;
  /** True when the load comes from publishing, which throttling reduces. */
  readonly isThrottleUseful: boolean;
}

/** Share of the work from which a client counts as heavy. */
const MUCH_WORK = 0.5;
/** Utilisation of the master's thread below which load is no problem, percent. */
const BUSY_PERCENT = 50;
/** Problem codes of clients that indicate load, in order of precedence. */
const LOAD_PROBLEMS = ['client_slow', 'client_throttled', 'publisher_noisy'];

/**
 * Ranks the clients that cause load, highest first.
 * @param busyPercent utilisation of the master's thread
 */
export function rankLoads(
  views: readonly ClientView[],
  measure: LoadMeasure,
  busyPercent: number,
): ClientLoad[] {
  return views
    .flatMap((view) => (view.activity ? [loadOf(view, view.activity, busyPercent)] : []))
    .filter((load) => load.isTrouble || load.workShare > 0 || load.queuedBytes > 0)
    .sort(
      (a, b) =>
        loadValue(b, measure) - loadValue(a, measure) ||
        Number(b.isTrouble) - Number(a.isTrouble) ||
        a.view.label.localeCompare(b.view.label),
    );
}

export function loadValue(load: ClientLoad, measure: LoadMeasure): number {
  if (measure === 'work') return load.workShare;
  return measure === 'bandwidth' ? load.bytesPerSecond : load.queuedBytes;
}

function loadOf(view: ClientView, activity: ClientActivity, busyPercent: number): ClientLoad {
  const { bytesInPerSecond, bytesOutPerSecond, queuedBytes, workShare } = activity;
  const problem = LOAD_PROBLEMS.map((code) => view.problems.find((one) => one.code === code)).find(
    (one) => one !== undefined,
  );
  const heavy = workShare >= MUCH_WORK && busyPercent >= BUSY_PERCENT;
  return {
    view,
    workShare,
    bytesPerSecond: bytesInPerSecond + bytesOutPerSecond,
    queuedBytes,
    ...(problem
      ? { cause: withoutName(problem.text, view.label), remedy: problem.remedy }
      : ownWords(activity, heavy)),
    isTrouble: problem !== undefined || heavy || activity.queuedRecords > 0,
    isThrottleUseful: activity.throttle !== undefined || activity.recordsInPerSecond > 0,
  };
}

function ownWords(activity: ClientActivity, isHeavy: boolean): { cause: string; remedy: string } {
  const { recordsInPerSecond, recordsOutPerSecond, bytesInPerSecond, bytesOutPerSecond } = activity;
  if (activity.queuedRecords > 0) {
    return {
      cause: `Receives more slowly than data arrives: ${formatNumber(activity.queuedRecords)} records are queued.`,
      remedy: 'Subscribe to fewer topics or at a lower rate, or use a faster network.',
    };
  }
  if (recordsInPerSecond >= recordsOutPerSecond) {
    return {
      cause: `Publishes ${flow(recordsInPerSecond, bytesInPerSecond)}.`,
      remedy: isHeavy ? 'Publish fewer or smaller records, or throttle the client.' : '',
    };
  }
  const why = activity.watchesEverything ? '. One of its devices subscribes to every topic' : '';
  return {
    cause: `Receives ${flow(recordsOutPerSecond, bytesOutPerSecond)}${why}.`,
    remedy: isHeavy ? 'Subscribe to fewer topics, or at a lower rate.' : '',
  };
}

function flow(records: number, bytes: number): string {
  const { digits, unit } = formatBytes(bytes, 'B/s');
  const many = Math.round(records);
  return `${formatNumber(many)} ${plural(many, 'record')} per second, ${digits} ${unit ?? ''}`;
}

/** Removes the name from the master's sentence, because it is shown beside it. */
function withoutName(text: string, name: string): string {
  if (!text.startsWith(`${name} `)) return text;
  const rest = text.slice(name.length + 1);
  return rest.charAt(0).toLocaleUpperCase() + rest.slice(1);
}
