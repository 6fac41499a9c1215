import { nodeName } from './commands/command-label.ts';
import type { Graph, GraphNode } from './graph.ts';
import { wiresOf } from './wires-of.ts';

/** A search result. */
export interface SearchHit {
  readonly node: string;
  /** Display name of the node. */
  readonly name: string;
  /** Kind of the matching text: `topic`, `input`, `value`, … */
  readonly where: string;
  /** The matching text. */
  readonly text: string;
}

/** Finds nodes whose texts contain all words of a query; names that start with the query come first. */
export function searchGraph(graph: Graph, query: string): SearchHit[] {
  const words = query.toLocaleLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const found: { hit: SearchHit; rank: number }[] = [];
  for (const node of graph.nodes.values()) {
    const texts = [...textsOf(graph, node)];
    const lower = texts.map(([, text]) => text.toLocaleLowerCase());
    const places = words.map((word) => lower.findIndex((text) => text.includes(word)));
    if (places.includes(-1)) continue;
    const [where, text] = texts[Math.max(...places)] ?? ['name', ''];
    const name = nodeName(node);
    const ranks = words.map((word) => rankOf(name.toLocaleLowerCase(), word));
    const rank = Math.min(...ranks) + Math.max(...places);
    found.push({ hit: { node: node.id, name, where, text }, rank });
  }
  return found.sort((a, b) => a.rank - b.rank).map(({ hit }) => hit);
}

function rankOf(name: string, word: string): number {
  if (name.startsWith(word)) return 0;
  return name.includes(word) ? 100 : 200;
}

/** Texts of a node, in order of relevance. */
function* textsOf(graph: Graph, node: GraphNode): Iterable<readonly [where: string, text: string]> {
  yield ['name', nodeName(node)];
  switch (node.kind) {
    case 'topic':
      yield ['format', node.format ?? ''];
      break;
    case 'module': {
      const { description, tags } = node.module;
      yield ['description', description];
      for (const tag of tags) yield ['tag', tag];
      for (const { direction, name, formatText } of node.ports) {
        yield [direction === 'in' ? 'input' : 'output', name];
        yield ['format', formatText];
      }
      for (const [, json] of node.constants) yield ['value', json];
      const wires = wiresOf(graph, node.id);
      for (const { via = '' } of [...wires.in, ...wires.out]) yield ['topic', via];
      break;
    }
    case 'muxer':
      yield ['topics', node.mux.topicGlob];
      yield ['topics', node.mux.topicSelector];
      yield ['format', node.mux.dataType];
      break;
    case 'demuxer':
      yield ['topics', node.demux.outputTopicFormat];
      yield ['format', node.demux.dataType];
      break;
    case 'constant':
      yield ['value', node.json];
      break;
    case 'comment':
      yield ['text', node.text];
      break;
    case 'frame':
      break;
  }
}
