import { isExtensionTopic, isMasterTopic, type ProcessingModule } from '@ubii/proto';
import { rankModules, type FormatsAtHand } from '../../modules/library/rank-modules.ts';
import { formatsAtHand } from '../model/fit/at-hand.ts';
import { fittingNodes } from '../model/fit/fitting.ts';
import type { KnownTopic, NodeOffer } from '../model/fit/node-offer.ts';
import type { Graph, PortRef } from '../model/graph.ts';
import { moduleNode } from '../model/make-node.ts';
import { insertionOf } from '../model/selection/insert.ts';
import type { NewNode } from './new-nodes.ts';

/** Modules and topics that can be added. */
export interface AddableSources {
  readonly modules: readonly ProcessingModule[];
  readonly topics: readonly KnownTopic[];
  /** Returns the display name of a topic; the search matches it, too. */
  readonly nameTopic?: (topic: string) => string;
}

/** A node to add, alone or at the end of a wire; or an existing socket to connect. */
export type Addable = {
  readonly key: string;
  readonly text: string;
  readonly hint: string;
} & (
  | { readonly item: NewNode; readonly offer?: undefined; readonly port?: undefined }
  | { readonly item?: undefined; readonly offer: NodeOffer; readonly port?: undefined }
  | { readonly item?: undefined; readonly offer?: undefined; readonly port: PortRef }
);

const MAX_SHOWN = 60;
/** Most topics in the list, so that modules are visible, too; typing finds the others. */
const MAX_TOPICS = 30;
const PARTS = {
  muxer: 'Muxer',
  demuxer: 'Demuxer',
  constant: 'Value',
  comment: 'Note',
  frame: 'Frame',
} as const;

/**
 * Returns the nodes that match the typed words and, if there is one, the dangling wire.
 * @param end fixed end of the wire
 */
export function addables(
  graph: Graph,
  { modules, topics, nameTopic }: AddableSources,
  typed: string,
  end: PortRef | undefined,
): Addable[] {
  const known = topics.filter(({ topic }) => !isMasterTopic(topic) && !isExtensionTopic(topic));
  const found =
    end === undefined
      ? bestFirst(looseItems(modules, known), typed, formatsAtHand(graph), nameTopic)
      : withFewTopics(bestFirst(offers(graph, end, modules, known), typed, undefined, nameTopic));
  return [...found, ...newTopic(graph, typed.trim(), known, end)].slice(0, MAX_SHOWN);
}

function withFewTopics(found: readonly Addable[]): Addable[] {
  let topics = 0;
  return found.filter(({ offer }) => offer?.kind !== 'topic' || (topics += 1) <= MAX_TOPICS);
}

/** Returns the modules that match the typed words and can be inserted into a wire. */
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
  return bestFirst(looseModules(fitting), typed, formatsAtHand(graph)).slice(0, MAX_SHOWN);
}

/** Returns the module that would be added; undefined for other nodes. */
export function moduleOf({ item, offer }: Addable): ProcessingModule | undefined {
  if (item?.kind === 'module') return item.module;
  return offer?.kind === 'module' ? offer.module : undefined;
}

/**
 * Returns the entries that match all words, with modules in order of relevance.
 * @param atHand undefined: equally relevant modules keep their order
 */
function bestFirst(
  all: readonly Addable[],
  typed: string,
  atHand: FormatsAtHand | undefined,
  nameTopic: AddableSources['nameTopic'] = (topic) => topic,
): Addable[] {
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean);
  const has = ({ text, hint }: Addable): boolean =>
    words.every((word) => `${text} ${nameTopic(text)} ${hint}`.toLowerCase().includes(word));
  const isModule = (one: Addable): boolean => moduleOf(one) !== undefined;
  const at = Math.max(0, all.findIndex(isModule));
  const others = (part: readonly Addable[]): Addable[] =>
    part.filter((one) => !isModule(one) && has(one));
  const modules = rankModules(all.filter(isModule), (one) => moduleOf(one)!, words, atHand);
  return [...others(all.slice(0, at)), ...modules, ...others(all.slice(at))];
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

/** A topic with the typed name, which has no publisher yet. */
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
