import type { TopicRate } from '../../connection/topic-rates.ts';

/**
 * A level of the topic tree. May be a topic and a branch at once, as `/a` beside `/a/b`. Renewed in
 * place and outside reactivity; the model says when to look again.
 */
export class TopicNode {
  /** The topic up to and with this level; unique in the tree. */
  readonly key: string;
  readonly label: string;
  /** 1 for a root, 0 for the invisible node above the roots. */
  readonly level: number;
  readonly parent: TopicNode | undefined;
  readonly children = new Map<string, TopicNode>();
  /** The topic that ends here, if one does. */
  rate: TopicRate | undefined;
  isExpanded = true;
  /** Stands in for `isExpanded` while a search is on, which opens everything it finds. */
  isExpandedInSearch = true;
  /** The topic passes the search. */
  isFound = true;

  /** Of the topics at and below this level that pass the search: how many, */
  count = 0;
  /** records per second, */
  hz = 0;
  bytesPerSecond = 0;
  /** whether a rate is known of any of them, */
  isRateKnown = false;
  /** and when the newest record came: milliseconds since the Unix epoch, master's clock. */
  publishedMs = 0;

  /** The children in the order of the tree; `undefined` when it must be worked out. */
  sorted: TopicNode[] | undefined;
  /** Place among the rows of its parent, from 1, and how many those are. */
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

  /** For comparing names as people do: numbers by value, case ignored. */
  get nameKey(): string {
    return (this.#nameKey ??= nameKeyOf(this.label));
  }

  /** The topic holds a value now. */
  get hasValue(): boolean {
    return this.rate !== undefined && this.rate.statistic.dataFormat !== '';
  }
}

/** Text that sorts as people sort names: `Sensor 9` before `sensor 10`. */
export function nameKeyOf(name: string): string {
  return name.toLowerCase().replace(/\d+/g, (digits) => digits.padStart(12, '0'));
}
