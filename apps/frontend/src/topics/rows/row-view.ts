import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatRate } from '../../ui/readouts/format-rate.ts';
import { formatAge } from '../../ui/readouts/format-time.ts';
import { NO_VALUE, type Readout } from '../../ui/readouts/readout.ts';
import { isPublisherAway, type FindPublisher, type Publisher } from '../names/publisher.ts';
import type { TopicNode } from '../tree/topic-node.ts';
import { rootLabel } from '../names/topic-path.ts';
import { isStale } from './staleness.ts';

/** Texts of a row. */
export interface RowView {
  readonly name: string;
  /** Client of the row; only for roots. */
  readonly publisher: Publisher | undefined;
  readonly hz: string;
  readonly bandwidth: Readout;
  readonly age: Readout;
  /** Age of the newest record, milliseconds; `undefined` without one. */
  readonly ageMs: number | undefined;
  readonly isStale: boolean;
  readonly isResting: boolean;
}

/** Name of an empty level. */
const NO_NAME = '(no name)';

/** Name of a row: for a root, the name of its client, if it has one. */
export function nameOf(node: TopicNode, findPublisher: FindPublisher): string {
  const publisher = node.level === 1 ? findPublisher(node.label) : undefined;
  return publisher?.name ?? (node.label || NO_NAME);
}

/** @param nowMs epoch milliseconds, master's clock */
export function rowView(node: TopicNode, findPublisher: FindPublisher, nowMs: number): RowView {
  const publisher = node.level === 1 ? findPublisher(node.label) : undefined;
  const ageMs = node.publishedMs === 0 ? undefined : Math.max(0, nowMs - node.publishedMs);
  return {
    name: nameOf(node, findPublisher),
    publisher,
    hz: node.isRateKnown ? formatRate(node.hz) : NO_VALUE.digits,
    bandwidth: node.isRateKnown ? formatBytes(node.bytesPerSecond, '') : NO_VALUE,
    age: ageMs === undefined ? NO_VALUE : formatAge(ageMs),
    ageMs,
    isStale: isNodeStale(node, findPublisher, nowMs),
    isResting: node.hz < 0.05,
  };
}

/** A topic is stale relative to its usual rate; a branch only when its client is away. */
function isNodeStale(node: TopicNode, findPublisher: FindPublisher, nowMs: number): boolean {
  if (node.rate === undefined || node.isBranch) {
    const isRootAway = findPublisher(rootLabel(node.key))?.isAway === true;
    return isRootAway && node.publishedMs > 0 && nowMs - node.publishedMs > 5000;
  }
  const { publisherId } = node.rate.statistic;
  return isStale(node.rate, isPublisherAway(node.key, publisherId, findPublisher), nowMs);
}
