import type { TopicRate } from '../../connection/topic-rates.ts';
import { TopicNode } from './topic-node.ts';
import { topicLevels } from '../names/topic-path.ts';

/** Tree of all topics by level. Adding and removing costs O(levels), independent of the number of topics. */
export class TopicTree {
  /** Parent of the roots; never shown. */
  readonly top = new TopicNode('', '', 0, undefined);
  readonly #nodes = new Map<string, TopicNode>();

  /** The node of a topic or of a branch. */
  find(key: string): TopicNode | undefined {
    return this.#nodes.get(key);
  }

  /** All nodes, parents before children. */
  nodes(): Iterable<TopicNode> {
    return this.#nodes.values();
  }

  /** @returns the created levels, outermost first, and the topic's node */
  add(rate: TopicRate): { node: TopicNode; created: TopicNode[] } {
    const created: TopicNode[] = [];
    let node = this.top;
    for (const { key, label } of topicLevels(rate.statistic.topic)) {
      let child = node.children.get(key);
      if (child === undefined) {
        child = new TopicNode(key, label, node.level + 1, node);
        node.children.set(key, child);
        node.sorted = undefined;
        this.#nodes.set(key, child);
        created.push(child);
      }
      node = child;
    }
    node.rate = rate;
    return { node, created };
  }

  /** Removes a topic, and branches that become empty. Ignores unknown topics. */
  remove(rate: TopicRate): void {
    let node = this.#nodes.get(rate.statistic.topic);
    if (node?.rate !== rate) return;
    node.rate = undefined;
    while (node?.parent && node.rate === undefined && node.children.size === 0) {
      node.parent.children.delete(node.key);
      node.parent.sorted = undefined;
      this.#nodes.delete(node.key);
      node = node.parent;
    }
  }
}

/**
 * Computes the totals of each node.
 * @param counts whether a topic is included
 */
export function summarise(node: TopicNode, counts: (node: TopicNode) => boolean): void {
  const { rate } = node;
  const isCounted = rate !== undefined && counts(node);
  node.count = isCounted ? 1 : 0;
  node.hz = isCounted ? (rate.hz ?? 0) : 0;
  node.bytesPerSecond = isCounted ? (rate.bytesPerSecond ?? 0) : 0;
  node.isRateKnown = isCounted && rate.hz !== undefined;
  node.publishedMs = isCounted ? rate.statistic.publishedMs : 0;
  for (const child of node.children.values()) {
    summarise(child, counts);
    node.count += child.count;
    node.hz += child.hz;
    node.bytesPerSecond += child.bytesPerSecond;
    node.isRateKnown ||= child.isRateKnown;
    if (child.publishedMs > node.publishedMs) node.publishedMs = child.publishedMs;
  }
}
