import type { TopicChanges } from '../../connection/topic-rates.ts';
import type { FindPublisher } from '../names/publisher.ts';
import { EMPTY_FILTER, type TopicFilter } from './topic-filter.ts';
import type { TopicNode } from './topic-node.ts';
import { isRanking, sortChildren, type TopicOrder } from './topic-order.ts';
import { rootLabel } from '../names/topic-path.ts';
import { summarise, TopicTree } from './topic-tree.ts';

/** Totals of all topics, independent of the search. */
export interface TopicTotals {
  readonly topics: number;
  /** Number of publishing clients. */
  readonly publishers: number;
  /** Records per second. */
  readonly hz: number;
  readonly bytesPerSecond: number;
}

/** Branches with more children than this are collapsed initially, */
const WIDE_BRANCH = 64;
/** and so are all but the first level when there are more topics than this. */
const MANY_TOPICS = 1000;
const FEW_ROOTS = 8;
/** Shortest interval between changes of the order by data, milliseconds. */
const RANKING_MS = 1000;

/** Topics as rows of a tree. Without reactivity and clock: `refresh` receives the time. */
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

  /** Visible rows, top to bottom. A new array whenever rows or their order changed. */
  get rows(): readonly TopicNode[] {
    return this.#rows;
  }

  get totals(): TopicTotals {
    return this.#totals;
  }

  /** Number of topics that match search and format. */
  get found(): number {
    return this.#found;
  }

  get isSearching(): boolean {
    return !this.#filter.isEmpty || this.#format !== undefined;
  }

  find(key: string): TopicNode | undefined {
    return this.#tree.find(key);
  }

  /** Data formats in use, in alphabetical order. */
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
    // Only set on creation; later the user's choice stays.
    for (const node of created) node.isExpanded = this.#beginsExpanded(node);
    this.#isDirty = true;
  }

  #beginsExpanded({ children, level }: TopicNode): boolean {
    if (children.size > WIDE_BRANCH) return false;
    if (this.#topics <= MANY_TOPICS) return true;
    return level === 1 && this.#tree.top.children.size <= FEW_ROOTS;
  }

  /** Clients were added, removed or renamed. */
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

  /** Expands the branches above a topic or branch. */
  reveal(key: string): void {
    const node = this.#tree.find(key);
    for (let above = node?.parent; above; above = above.parent) this.setExpanded(above, true);
  }

  /**
   * Computes the totals of the newest rates and, if necessary, the rows.
   * @param nowMs of any clock; limits how often the order by data changes
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
    const clients = [...publishers].filter((id) => this.#findPublisher(id)?.isClient);
    this.#totals = { topics: this.#topics, publishers: clients.length, hz, bytesPerSecond };
    // A data format may appear or disappear without a topic doing so.
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
