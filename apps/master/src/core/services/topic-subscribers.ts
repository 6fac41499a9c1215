import {
  globToRegExpSource,
  ServiceError,
  type Init,
  type SubscribedModule,
  type TopicMux,
  type TopicSubscribers,
} from '@ubii/proto';
import { roleRefusal } from '../access/join-refusals.ts';
import { JOINED } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { quote } from '../texts/quote.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import { definer } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

/** Topics of one request: what a page shows. */
const MAX_TOPICS = 16;

type Context = Pick<
  Core,
  'id' | 'topics' | 'clients' | 'selectionTable' | 'patternTable' | 'sessions'
>;

/** Says who receives topics. Players learn how many receive their own, and no names. [EX-95] [EX-96] */
export const topicSubscribers = definer<keyof Context>()('topicSubscribers', {
  roles: JOINED,
  handle(core, { topics }, { caller }) {
    if (topics.length > MAX_TOPICS) {
      throw new ServiceError(
        'invalid_argument',
        `The request names ${topics.length} topics, but one request names at most ${MAX_TOPICS}.`,
      );
    }
    if (caller.role !== 'player') {
      return { elements: topics.map((topic) => subscribersOf(core, topic)) };
    }
    for (const topic of topics) requireOwn(caller, topic);
    return {
      elements: topics.map((topic) => ({ topic, count: subscribersOf(core, topic).count })),
    };
  },
  gather: ({ elements }, others) => ({
    elements: (elements ?? []).map((own, i) =>
      others.reduce((all, { elements: of }) => both(all, of[i]), own),
    ),
  }),
});

/** The subscribers of a topic here, and at another master. */
function both(
  own: Init<TopicSubscribers>,
  other: TopicSubscribers | undefined,
): Init<TopicSubscribers> {
  if (other === undefined) return own;
  return {
    ...own,
    count: (own.count ?? 0) + other.count,
    clientIds: [...(own.clientIds ?? []), ...other.clientIds],
    modules: [...(own.modules ?? []), ...other.modules],
  };
}

/** [EX-96] */
function requireOwn(caller: ServiceCall['caller'], topic: string): void {
  if (caller.kind === 'client' && topic.startsWith(`/${caller.clientId}/`)) return;
  throw roleRefusal(
    `A player may list the receivers of its own topics only, and ${quote(topic)} is not one of them.`,
  );
}

function subscribersOf(core: Context, topic: string): Init<TopicSubscribers> & { count: number } {
  const entry = core.topics.get(topic);
  if (entry === undefined) return { topic, count: 0 };
  // The master and its modules are no client.
  const isRegistered = (id: string): boolean =>
    core.clients.get(id)?.socket !== undefined || id === core.id;
  const clientIds = [...core.topics.subscriberIds(entry)].filter(isRegistered);
  return { topic, count: clientIds.length, clientIds, modules: [...modulesOf(core, entry)] };
}

/** The modules of live sessions that have the topic on an input, each once [EX-97]. */
function* modulesOf(core: Context, entry: TopicEntry): Iterable<Init<SubscribedModule>> {
  for (const session of core.sessions.list()) {
    for (const module of session.isLive ? session.modules : []) {
      const takes = module.mapping.inputMappings.some(({ topic, topicMux }) =>
        topicMux === undefined ? topic === entry.topic : selects(core, topicMux, entry),
      );
      if (!takes || !module.isPlaced) continue;
      const { name, nodeId } = module;
      yield { name, nodeId, sessionId: session.id, sessionName: session.description.name };
    }
  }
}

/** The node of the module has subscribed to the same, so that it is known what matches. */
function selects(core: Context, mux: TopicMux, entry: TopicEntry): boolean {
  if (mux.component !== undefined) {
    return core.selectionTable.get(mux.component)?.entries.has(entry) === true;
  }
  const source = mux.topicGlob === '' ? mux.topicSelector : globToRegExpSource(mux.topicGlob);
  return core.patternTable.get(source)?.entries.has(entry) === true;
}
