import { isExtensionTopic, isMasterTopic, parseDataFormat, type TopicStatistic } from '@ubii/proto';
import { isInternalTopic } from '../../topics/names/internal-topics.ts';
import { connectables } from '../canvas/connectable.ts';
import type { GraphCommand } from '../model/commands/graph-command.ts';
import { fittingNodes, offerCommand } from '../model/fit/fitting.ts';
import type { Graph, Point, PortRef } from '../model/graph.ts';
import { portFormat } from '../model/port-format.ts';
import { topicsOf } from '../model/commands/free-topic.ts';

/** Source that fits an input, with the command that connects it. */
export interface InputOffer {
  /** Module and output, or topic. */
  readonly name: string;
  readonly format: string;
  readonly command: GraphCommand;
}

interface OfferOptions {
  readonly uuid: () => string;
  /** Position of the module; undefined: not placed yet. */
  readonly place: Point | undefined;
  /** Whether a node waits itself, so that it outputs nothing. */
  readonly waits: (node: string) => boolean;
}

/** Most sources that are offered. */
const MAX_OFFERS = 3;
/** Distance of a new topic node to the left of the module, canvas units. */
const TO_THE_LEFT = 280;

/**
 * Returns the sources that fit an input, best first: sockets of the graph, then live topics. [SE-70]
 * @param known statistics of all topics
 */
export function inputOffers(
  graph: Graph,
  to: PortRef,
  known: readonly Pick<TopicStatistic, 'topic' | 'dataFormat' | 'publishedMs'>[],
  { uuid, place, waits }: OfferOptions,
): InputOffer[] {
  const present = topicsOf(graph);
  const topics = known
    .filter(({ publishedMs }) => publishedMs > 0)
    .filter(
      ({ topic }) => !isMasterTopic(topic) && !isExtensionTopic(topic) && !isInternalTopic(topic),
    )
    .filter(({ topic, dataFormat }) => parseDataFormat(dataFormat) && !present.has(topic))
    .map(({ topic, dataFormat: format }) => ({ topic, format }));
  const sockets = connectables(graph, to, '', topics, () => undefined)
    .filter(({ isLoop, port }) => !isLoop && port !== undefined && !waits(port.node))
    .flatMap(({ text: name, port: from }): InputOffer[] =>
      from === undefined
        ? []
        : [{ name, format: portFormat(graph, from) ?? '', command: { kind: 'connect', from, to } }],
    );
  const options = { uuid, ...(place && { position: { x: place.x - TO_THE_LEFT, y: place.y } }) };
  const live = fittingNodes(graph, to, [], topics).flatMap((offer): InputOffer[] => {
    if (offer.kind !== 'topic' || present.has(offer.topic)) return [];
    const command = offerCommand(graph, to, offer, options);
    return [{ name: offer.topic, format: offer.format ?? '', command }];
  });
  return [...sockets, ...live].slice(0, MAX_OFFERS);
}
