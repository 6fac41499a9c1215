import type { TopicRate } from '../../connection/topic-rates.ts';

/**
 * Level of the topic tree. May be a topic and a branch at once, as `/a` beside `/a/b`. Mutated in place and not
 * reactive; the model signals changes.
 */
export class TopicNode {
  /** The topic up to and including this level; unique in the tree. */
  readonly key: string;
  readonly label: string;
  /** 1 for a root, 0 for the invisible node above the roots. */
  readonly level: number;
  readonly parent: TopicNode | undefined;
  readonly children = new Map<string, TopicNode>();
  /** The topic that ends here, if one does. */
  rate: TopicRate | undefined;
  isExpanded = true;
  /** Replaces `isExpanded` during a search, which expands all matches. */
  isExpandedInSearch = true;
  /** True when the topic matches the search. */
  isFound = true;

  /** Totals of the matching topics at and below this level: their number, */
  count = 0;
  /** records per second, */
  hz = 0;
  bytesPerSecond = 0;
  /** whether any of their rates is known, */
  isRateKnown = false;
  /** and the time of the newest record: epoch milliseconds, master's clock. */
  publishedMs = 0;

  /** Children in display order; `undefined` when it must be recomputed. */
  sorted: TopicNode[] | undefined;
  /** Position among the rows of its parent, from 1, and their number. */
  position = 1;
  setSize = 1;
  #nameKey: string | undefined;

  constructor(key: string, label: string, level: number, parent: TopicNode | undefined) {
    this.key = key;
    this.label = label;
    this.level = level;
    this.parent = parent;
  }

  get isBranch(): boolean {
    return this.children.size > 0;
  }

  /** Key for natural sorting: numbers by value, case-insensitive. */
  get nameKey(): string {
    return (this.#nameKey ??= nameKeyOf(this.label));
  }

  /** True while the topic has a value. */
  get hasValue(): boolean {
    return this.rate !== undefined && this.rate.statistic.dataFormat !== '';
  }
}

/** Key for natural sorting: `Sensor 9` before `sensor 10`. */
export function nameKeyOf(name: string): string {
  return name.toLowerCase().replace(/\d+/g, (digits) => digits.padStart(12, '0'));
}
