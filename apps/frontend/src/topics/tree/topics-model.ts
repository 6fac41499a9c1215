import type { TopicChanges } from '../../connection/topic-rates.ts';
import type { FindPublisher } from '../names/publisher.ts';
import { EMPTY_FILTER, type TopicFilter } from './topic-filter.ts';
import type { TopicNode } from './topic-node.ts';
import { isRanking, sortChildren, type TopicOrder } from './topic-order.ts';
import { rootLabel } from '../names/topic-path.ts';
import { summarise, TopicTree } from './topic-tree.ts';

/** Of all topics, whatever is searched for. */
export interface TopicTotals {
  readonly topics: number;
  /** Clients that publish them. */
  readonly publishers: number;
  /** Records per second. */
  readonly hz: number;
  readonly bytesPerSecond: number;
}

/** Branches with more children than this begin collapsed, */
const WIDE_BRANCH = 64;
/** and so do all but the first level when there are more topics than this. */
const MANY_TOPICS = 1000;
const FEW_ROOTS = 8;
/** How often a ranking may move rows, milliseconds. */
const RANKING_MS = 1000;

/** The topics as rows of a tree. No reactivity, no clock: `refresh` says what time it is. */
export class TopicsModel {
  readonly #tree = new TopicTree();
  readonly #findPublisher: FindPublisher;
  #filter: TopicFilter = EMPTY_FILTER;
  #format: string | undefined;
  #order: TopicOrder = 'name';
  #rankedMs = -Infinity;
  #topics = 0;
  #rows: readonly TopicNode[] = [];
  #totals: TopicTotals = { topics: 0, publishers: 0, hz: 0, bytesPerSecond: 0 };
  #found = 0;
  #isDirty = true;

  constructor(findPublisher: FindPublisher) {
    this.#findPublisher = findPublisher;
  }

  /** What is shown, top to bottom. A new array whenever the rows or their order changed. */
  get rows(): readonly TopicNode[] {
    return this.#rows;
  }

  get totals(): TopicTotals {
    return this.#totals;
  }

  /** Topics that pass the search and the format. */
  get found(): number {
    return this.#found;
  }

  get isSearching(): boolean {
    return !this.#filter.isEmpty || this.#format !== undefined;
  }

  find(key: string): TopicNode | undefined {
    return this.#tree.find(key);
  }

  /** The data formats there are, in alphabetical order. */
  formats(): string[] {
    const formats = new Set<string>();
    for (const { rate } of this.#tree.nodes()) if (rate) formats.add(rate.statistic.dataFormat);
    formats.delete('');
    return [...formats].sort();
  }

  apply({ added, removed }: TopicChanges): void {
    if (added.length + removed.length === 0) return;
    for (const rate of removed) this.#tree.remove(rate);
    this.#topics += added.length - removed.length;
    const created: TopicNode[] = [];
    for (const rate of added) {
      const result = this.#tree.add(rate);
      this.#checkFilter(result.node);
      created.push(...result.created);
    }
    // Decided once, when it appears: what a person opened or closed later stays so.
    for (const node of created) node.isExpanded = this.#beginsExpanded(node);
    this.#isDirty = true;
  }

  #beginsExpanded({ children, level }: TopicNode): boolean {
    if (children.size > WIDE_BRANCH) return false;
    if (this.#topics <= MANY_TOPICS) return true;
    return level === 1 && this.#tree.top.children.size <= FEW_ROOTS;
  }

  /** Clients came, went or changed their names. */
  handlePublishers(): void {
    this.#tree.top.sorted = undefined;
    if (!this.#filter.isEmpty) this.#checkAll();
    this.#isDirty = true;
  }

  setFilter(filter: TopicFilter): void {
    this.#filter = filter;
    this.#checkAll();
  }

  /** @param format short name; `undefined` for all */
  setFormat(format: string | undefined): void {
    this.#format = format;
    this.#checkAll();
  }

  setOrder(order: TopicOrder): void {
    this.#order = order;
    this.#unsort();
  }

  isExpanded(node: TopicNode): boolean {
    return this.isSearching ? node.isExpandedInSearch : node.isExpanded;
  }

  setExpanded(node: TopicNode, expanded: boolean): void {
    if (this.isSearching) node.isExpandedInSearch = expanded;
    else node.isExpanded = expanded;
    this.#isDirty = true;
  }

  setAllExpanded(expanded: boolean): void {
    for (const node of this.#tree.nodes()) this.setExpanded(node, expanded);
  }

  /** Opens what is above a topic or a branch. */
  reveal(key: string): void {
    const node = this.#tree.find(key);
    for (let above = node?.parent; above; above = above.parent) this.setExpanded(above, true);
  }

  /**
   * Sums up the newest rates and, when something moved, lays out the rows again.
   * @param nowMs any clock; bounds how often a ranking moves rows
   */
  refresh(nowMs: number): void {
    this.#summarise();
    if (isRanking(this.#order) && nowMs - this.#rankedMs >= RANKING_MS) {
      this.#rankedMs = nowMs;
      this.#unsort();
    }
    if (!this.#isDirty) return;
    this.#isDirty = false;
    const rows: TopicNode[] = [];
    this.#lay(this.#tree.top, rows);
    if (!isSame(rows, this.#rows)) this.#rows = rows;
  }

  #summarise(): void {
    const publishers = new Set<string>();
    let [hz, bytesPerSecond] = [0, 0];
    summarise(this.#tree.top, (node) => {
      const { statistic } = node.rate!;
      publishers.add(statistic.publisherId);
      hz += node.rate!.hz ?? 0;
      bytesPerSecond += node.rate!.bytesPerSecond ?? 0;
      return node.isFound && (this.#format === undefined || statistic.dataFormat === this.#format);
    });
    publishers.delete('');
    this.#totals = { topics: this.#topics, publishers: publishers.size, hz, bytesPerSecond };
    // A format may come or go without a topic doing so.
    if (this.#found !== this.#tree.top.count) this.#isDirty = true;
    this.#found = this.#tree.top.count;
  }

  #lay(node: TopicNode, rows: TopicNode[]): void {
    node.sorted ??= sortChildren(node, this.#order, this.#findPublisher);
    const shown = node.sorted.filter(({ count }) => count > 0);
    shown.forEach((child, index) => {
      child.position = index + 1;
      child.setSize = shown.length;
      rows.push(child);
      if (child.isBranch && this.isExpanded(child)) this.#lay(child, rows);
    });
  }

  #unsort(): void {
    this.#tree.top.sorted = undefined;
    for (const node of this.#tree.nodes()) node.sorted = undefined;
    this.#isDirty = true;
  }

  #checkAll(): void {
    for (const node of this.#tree.nodes()) {
      node.isExpandedInSearch = true;
      if (node.rate) this.#checkFilter(node);
    }
    this.#isDirty = true;
  }

  #checkFilter(node: TopicNode): void {
    if (this.#filter.isEmpty) {
      node.isFound = true;
      return;
    }
    const { topic, publisherId } = node.rate!.statistic;
    const names = [rootLabel(topic), publisherId].flatMap((id) => [
      id,
      this.#findPublisher(id)?.name ?? '',
    ]);
    node.isFound = this.#filter.accepts(topic, names);
  }
}

function isSame(a: readonly TopicNode[], b: readonly TopicNode[]): boolean {
  return a.length === b.length && a.every((node, i) => node === b[i]);
}
