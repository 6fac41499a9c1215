import { isExtensionTopic, isMasterTopic, type ProcessingModule } from '@ubii/proto';
import { fittingNodes, type KnownTopic, type NodeOffer } from '../model/fit/fitting.ts';
import type { Graph, PortRef } from '../model/graph.ts';
import { moduleNode } from '../model/make-node.ts';
import { insertionOf } from '../model/selection/insert.ts';
import type { NewNode } from './new-nodes.ts';

/** What there is to choose from. */
export interface AddableSources {
  readonly modules: readonly ProcessingModule[];
  readonly topics: readonly KnownTopic[];
}

/** Something that can be added: by itself, or at the end of a wire. */
export type Addable = {
  readonly key: string;
  readonly text: string;
  readonly hint: string;
} & (
  | { readonly item: NewNode; readonly offer?: undefined }
  | { readonly item?: undefined; readonly offer: NodeOffer }
);

const MAX_SHOWN = 60;
const PARTS = {
  muxer: 'Muxer',
  demuxer: 'Demuxer',
  constant: 'Value',
  comment: 'Note',
  frame: 'Frame',
} as const;

/**
 * What fits the words typed, and the wire at hand if there is one.
 * @param end where the wire comes from
 */
export function addables(
  graph: Graph,
  { modules, topics }: AddableSources,
  typed: string,
  end: PortRef | undefined,
): Addable[] {
  const has = saying(typed);
  const known = topics.filter(({ topic }) => !isMasterTopic(topic) && !isExtensionTopic(topic));
  const all = end === undefined ? looseItems(modules, known) : offers(graph, end, modules, known);
  return [...all.filter(has), ...newTopic(graph, typed.trim(), known, end)].slice(0, MAX_SHOWN);
}

/** Modules that fit the words typed, and can go into a wire. */
export function insertables(
  graph: Graph,
  { modules }: AddableSources,
  typed: string,
  wireId: string,
): Addable[] {
  const wire = graph.wires.get(wireId);
  if (wire === undefined) return [];
  const fitting = modules.filter(
    (module) => insertionOf(graph, wire, moduleNode(module)) !== undefined,
  );
  return looseModules(fitting).filter(saying(typed)).slice(0, MAX_SHOWN);
}

/** What has all the words. */
function saying(typed: string): (one: Addable) => boolean {
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean);
  return ({ text, hint }) => {
    const all = `${text} ${hint}`.toLowerCase();
    return words.every((word) => all.includes(word));
  };
}

const looseModules = (modules: readonly ProcessingModule[]): Addable[] =>
  modules.map((module) => ({
    key: `module ${module.name}`,
    text: module.name,
    hint: 'module',
    item: { kind: 'module', module } as const,
  }));

function offers(
  graph: Graph,
  end: PortRef,
  modules: readonly ProcessingModule[],
  topics: readonly KnownTopic[],
): Addable[] {
  return fittingNodes(graph, end, modules, topics).map((offer) => {
    const isNew = offer.kind === 'topic' && offer.isNew;
    return {
      key: `${offer.kind} ${offer.label}`,
      text: isNew ? `New topic ${offer.label}` : offer.label,
      hint: offer.kind,
      offer,
    };
  });
}

function looseItems(
  modules: readonly ProcessingModule[],
  topics: readonly KnownTopic[],
): Addable[] {
  return [
    ...looseModules(modules),
    ...(Object.keys(PARTS) as (keyof typeof PARTS)[]).map((kind) => ({
      key: kind,
      text: PARTS[kind],
      hint: '',
      item: { kind },
    })),
    ...topics.map(({ topic, format }) => ({
      key: `topic ${topic}`,
      text: topic,
      hint: 'topic',
      item: { kind: 'topic', topic, format } as const,
    })),
  ];
}

/** A topic that nobody publishes yet, by the name typed. */
function newTopic(
  graph: Graph,
  typed: string,
  topics: readonly KnownTopic[],
  end: PortRef | undefined,
): Addable[] {
  if (typed === '' || /\s/.test(typed)) return [];
  const topic = typed.startsWith('/') ? typed : `/${typed}`;
  if (topics.some((known) => known.topic === topic)) return [];
  const words = { key: `new ${topic}`, text: `New topic ${topic}`, hint: 'topic' };
  if (end === undefined) return [{ ...words, item: { kind: 'topic', topic, format: '' } }];
  if (graph.nodes.get(end.node)?.kind !== 'module') return [];
  return [
    { ...words, offer: { kind: 'topic', label: topic, topic, isNew: true, format: undefined } },
  ];
}
