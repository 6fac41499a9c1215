import { isExtensionTopic, isMasterTopic, type ProcessingModule } from '@ubii/proto';
import {
  findableModule,
  firstSentence,
  moduleFlow,
  rankFound,
  type RankOptions,
} from '../../modules/library/rank-modules.ts';
import { formatLook } from '../../formats/families.ts';
import { queryWords } from '../../ui/find-words.ts';
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
  /** Topics that others use; names of new topics avoid them. */
  readonly used?: ReadonlySet<string>;
  /** Returns the display name of a topic; the search matches it, too. */
  readonly nameTopic?: (topic: string) => string;
}

/** A node to add, alone or at the end of a wire; or an existing socket to connect. */
export type Addable = {
  readonly key: string;
  readonly text: string;
  readonly hint: string;
  /** Why it does not fit the wire; undefined: it does. */
  readonly misfit?: string;
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
const SENTENCES: Readonly<Record<keyof typeof PARTS, string>> = {
  muxer: 'Collects the topics of all clients into one list.',
  demuxer: 'Splits a list into one topic for each client.',
  constant: 'Holds a value that you set by hand.',
  comment: 'Text on the canvas.',
  frame: 'Keeps nodes together under a title.',
};

/** What narrows what can be added, and what is preferred. */
export interface AddableWish {
  /** Fixed end of a dangling wire, which the nodes must fit. */
  readonly end?: PortRef | undefined;
  /** Names of modules that the user marked. */
  readonly favourites?: readonly string[] | undefined;
  /** Names of modules that were used lately. */
  readonly recent?: readonly string[] | undefined;
}

/** Returns the nodes that match the typed words and, if there is one, the dangling wire; best first. */
export function findAddables(
  graph: Graph,
  { modules, topics, used, nameTopic }: AddableSources,
  typed: string,
  { end, favourites, recent }: AddableWish,
): Addable[] {
  const known = topics.filter(({ topic }) => !isMasterTopic(topic) && !isExtensionTopic(topic));
  const all =
    end === undefined
      ? looseItems(modules, known)
      : offers(graph, end, { modules, topics: known, ...(used && { used }) });
  // What fits a wire is in the order of its fit, until words say more.
  const keepsOrder = end !== undefined && typed.trim() === '';
  const options = {
    atHand: end === undefined ? formatsAtHand(graph) : undefined,
    favourites,
    recent: keepsOrder ? undefined : recent,
  };
  return [
    ...bestFirst(all, typed, options, nameTopic),
    ...newTopic(graph, typed.trim(), known, end),
  ];
}

/**
 * Returns as many as a list shows.
 * @param end fixed end of the wire
 */
export function addables(
  graph: Graph,
  sources: AddableSources,
  typed: string,
  end: PortRef | undefined,
): Addable[] {
  return firstShown(findAddables(graph, sources, typed, { end }));
}

/** Returns as many as a list shows: with a wire few topics, so that modules are visible, too. */
export function firstShown(found: readonly Addable[]): Addable[] {
  return withFewTopics(found).slice(0, MAX_SHOWN);
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
  preferred: Pick<AddableWish, 'favourites' | 'recent'> = {},
): Addable[] {
  const wire = graph.wires.get(wireId);
  if (wire === undefined) return [];
  const fitting = modules.filter(
    (module) => insertionOf(graph, wire, moduleNode(module)) !== undefined,
  );
  return bestFirst(looseModules(fitting), typed, { atHand: formatsAtHand(graph), ...preferred });
}

/** Returns the module that would be added; undefined for other nodes. */
export function moduleOf({ item, offer }: Addable): ProcessingModule | undefined {
  if (item?.kind === 'module') return item.module;
  return offer?.kind === 'module' ? offer.module : undefined;
}

/** Kind of node that would be added; undefined for an existing socket. */
export const kindOf = ({ item, offer }: Addable): NewNode['kind'] | undefined =>
  item?.kind ?? offer?.kind;

/** Format of the topic that would be added, in any spelling; undefined for other nodes. */
export function topicFormat({ item, offer }: Addable): string | undefined {
  if (item?.kind === 'topic') return item.format;
  return offer?.kind === 'topic' ? (offer.format ?? '') : undefined;
}

/** One sentence about an entry, below its name. */
export function sentenceOf(one: Addable): string {
  const module = moduleOf(one);
  if (module !== undefined) {
    const flow = moduleFlow(module, (format) => formatLook(format).text);
    return firstSentence(module.description) || flow;
  }
  const format = topicFormat(one);
  if (format !== undefined) return format === '' ? one.hint : `topic, ${formatLook(format).text}`;
  const kind = kindOf(one);
  return kind === undefined || kind === 'topic' || kind === 'module' ? one.hint : SENTENCES[kind];
}

/** Returns the entries that match all words, best first. */
function bestFirst(
  all: readonly Addable[],
  typed: string,
  options: RankOptions,
  nameTopic: AddableSources['nameTopic'] = (topic) => topic,
): Addable[] {
  return rankFound(
    all,
    (one) => {
      const module = moduleOf(one);
      if (module !== undefined) return findableModule(module);
      const named = nameTopic(one.text);
      const aliases = named === one.text ? [] : [named];
      return { name: one.text, aliases, text: `${one.hint} ${sentenceOf(one)}` };
    },
    queryWords(typed),
    options,
  );
}

const looseModules = (modules: readonly ProcessingModule[]): Addable[] =>
  modules.map((module) => ({
    key: `module ${module.name}`,
    text: module.name,
    hint: 'module',
    item: { kind: 'module', module } as const,
  }));

function offers(graph: Graph, end: PortRef, { modules, topics, used }: AddableSources): Addable[] {
  return fittingNodes(graph, end, modules, topics, used).map((offer) => {
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
