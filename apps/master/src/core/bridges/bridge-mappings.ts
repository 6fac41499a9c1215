import {
  ServiceError,
  type BridgeAnswer,
  type BridgeMappings,
  type BridgeMappingsChange,
  type BridgeOrder,
  type Init,
} from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { TokenBucket } from '@ubii/timing';
import type { Client } from '../clients/client.ts';
import type { Limits } from '../limits/index.ts';
import { isAway, NodeRequests, type NodeRequestsContext } from '../nodes/node-requests.ts';
import { boundTexts } from '../texts/bound-texts.ts';
import { quote } from '../texts/quote.ts';

/** Requests to one bridge, of all callers: some pages, each of which asks at each pause of a person who types. */
const REQUESTS_PER_SECOND = 20;
/** Requests that wait for one bridge. */
const MAX_WAITING = 20;
/** Elements of lists in an answer; a bridge of ours sends fewer. */
const MAX_PROBLEMS = 500;
const MAX_MATCHES = 100;

type Order = Omit<Init<BridgeOrder>, 'number'>;

/** Dependencies for requests to bridges. */
export interface BridgeMappingsContext extends NodeRequestsContext {
  readonly limits: Limits;
}

/** Mappings of bridges, as the bridges tell and save them. The callers have been checked. [BR-80] */
export class BridgeMappingsOfClients {
  readonly #context: BridgeMappingsContext;
  readonly #requests: NodeRequests<Order, BridgeAnswer>;
  readonly #budgets = new Map<string, TokenBucket>();

  constructor(context: BridgeMappingsContext) {
    this.#context = context;
    this.#requests = new NodeRequests(context, {
      noun: 'bridge',
      maxWaiting: MAX_WAITING,
      encodeFrame: (order, number) => encodeNodeMessageFrame({ bridgeOrder: { ...order, number } }),
    });
    context.clients.onPresence.add((client) => {
      if (client.socket !== undefined) return;
      this.#budgets.delete(client.id);
      this.#requests.handleGone(client.id, quote(client.label));
    });
  }

  get(targetId: string): Promise<BridgeMappings> {
    return this.#ask(targetId, { get: { targetId } });
  }

  /** Checks mappings, and previews one with current values. [BR-81] */
  check(change: BridgeMappingsChange): Promise<BridgeMappings> {
    return this.#ask(change.targetId, { check: change });
  }

  /** @param author name of the client that asks [BR-82] */
  set(change: BridgeMappingsChange, author: string): Promise<BridgeMappings> {
    return this.#ask(change.targetId, { set: change, author });
  }

  handleAnswer({ id }: Client, answer: BridgeAnswer): void {
    this.#requests.handleAnswer(id, answer);
  }

  close(): void {
    this.#requests.close();
  }

  async #ask(targetId: string, order: Order): Promise<BridgeMappings> {
    const bridge = this.#requireBridge(targetId);
    const label = quote(bridge.label);
    const { mappings } = await this.#requests.ask(bridge.id, order);
    if (mappings === undefined) {
      throw new ServiceError('internal', `The bridge ${label} answered without its mappings.`);
    }
    return this.#bounded(mappings, label);
  }

  #requireBridge(targetId: string): Client {
    const { clients, clock } = this.#context;
    const client = clients.require(targetId, 'target_id');
    const label = quote(client.label);
    if (client.node?.isBridge !== true) {
      const text = `The client ${label} is no bridge of this version. Start one with npm run bridge, or choose another client.`;
      throw new ServiceError('failed_precondition', text);
    }
    if (client.socket === undefined) throw isAway(label, 'bridge');
    const nowMs = clock.monotonicMs();
    const budget = this.#budgets.get(client.id) ?? new TokenBucket(REQUESTS_PER_SECOND, nowMs);
    this.#budgets.set(client.id, budget);
    if (budget.take(1, nowMs)) return client;
    const text = `The bridge ${label} was asked more than ${REQUESTS_PER_SECOND} times in a second. Try again later.`;
    throw new ServiceError('resource_exhausted', text);
  }

  /** What a bridge says is passed on within the limits of texts only. [EX-70] */
  #bounded(mappings: BridgeMappings, label: string): BridgeMappings {
    const few = {
      ...mappings,
      problems: mappings.problems.slice(0, MAX_PROBLEMS),
      matches: mappings.matches.slice(0, MAX_MATCHES),
    };
    return boundTexts('ubii.extension.BridgeMappings', few, {
      limits: this.#context.limits,
      refuse: ({ member, limit, length }) =>
        new ServiceError(
          'resource_exhausted',
          `The bridge ${label} has ${length} characters in ${member}, more than ${limit} allows. Edit its mapping file by hand.`,
        ),
    });
  }
}
