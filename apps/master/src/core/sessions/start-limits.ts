import { ServiceError } from '@ubii/proto';
import { TokenBucket } from '@ubii/timing';
import type { GrantId } from '../access/grant.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { LimitName } from '../limits/index.ts';
import { isMaster, type Node } from '../nodes/node.ts';
import { chooseNode } from '../nodes/placement.ts';
import { quote } from '../texts/quote.ts';
import type { LifeContext } from './life-context.ts';
import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';

/** Burst of starts, seconds of the long-term rate. */
const BURST_SECONDS = 32;
/** Invitations with a rate of their own; the oldest is dropped first. */
const MAX_BUCKETS = 1_024;
/** Sessions that an error names as those that use the most memory. */
const MAX_NAMED = 3;

/** Why a session cannot be started now. */
interface MemoryShortage {
  readonly text: string;
  /** The limit of the master that is reached, if it is one of the master's. */
  readonly limit: LimitName | undefined;
  readonly details: { readonly neededBytes: number; readonly max: number };
}

/** Limits of starts: memory of nodes [SE-64], and the rate of announcements [EX-77]. */
export class StartLimits {
  readonly #context: LifeContext;
  readonly #limits: LimitWatch;
  readonly #buckets = new Map<GrantId | undefined, TokenBucket>();

  constructor(context: LifeContext, limits: LimitWatch) {
    this.#context = context;
    this.#limits = limits;
  }

  /**
   * Counts a start against the limits.
   *
   * @param maker Grant of the client that starts the session; undefined for callers without one.
   * @throws ServiceError when the session cannot be started now
   */
  spend(session: Session, maker: GrantId | undefined): void {
    this.#requireMemory(session);
    if (!session.isLive) this.#spendRate(session, maker);
  }

  /** Requires that the nodes of a session have the minimum memory of its modules [SE-64]. */
  #requireMemory(session: Session): void {
    const shortage = findShortage(this.#context, session);
    if (shortage === undefined) return;
    if (shortage.limit !== undefined) {
      this.#limits.count(shortage.limit, this.#context.nodes.masterId);
    }
    throw new ServiceError('resource_exhausted', shortage.text, { details: shortage.details });
  }

  /** A starting session is announced with its full content: limits the rate of each invitation. [EX-77] */
  #spendRate(session: Session, maker: GrantId | undefined): void {
    const nowMs = this.#context.clock.monotonicMs();
    const bucket = this.#bucketOf(maker, nowMs);
    const waitMs = bucket.waitMs(nowMs);
    if (waitMs === 0) {
      bucket.spend(session.byteLength, nowMs);
      return;
    }
    this.#limits.count('sessionStartBytesPerSecond');
    const { sessionStartBytesPerSecond: max } = this.#limits.limits;
    throw new ServiceError(
      'resource_exhausted',
      `A starting session is sent to all subscribers, and the sessions started recently were too large to start ${quote(session.label)} now (limit sessionStartBytesPerSecond). Try again in ${Math.ceil(waitMs / 1000)} s.`,
      { details: { limit: 'sessionStartBytesPerSecond', max } },
    );
  }

  #bucketOf(maker: GrantId | undefined, nowMs: number): TokenBucket {
    const known = this.#buckets.get(maker);
    if (known !== undefined) return known;
    const { sessionStartBytesPerSecond: perSecond } = this.#limits.limits;
    const bucket = new TokenBucket(perSecond, nowMs, BURST_SECONDS * perSecond);
    this.#buckets.set(maker, bucket);
    const [oldest] = this.#buckets.keys();
    if (this.#buckets.size > MAX_BUCKETS) this.#buckets.delete(oldest);
    return bucket;
  }
}

function findShortage(context: LifeContext, session: Session): MemoryShortage | undefined {
  for (const [node, modules] of byNode(context, session)) {
    const neededBytes = modules.reduce((sum, module) => sum + module.minMemoryBytes, 0);
    const shortage =
      (isMaster(node) ? shortageOfSession(context, session, neededBytes) : undefined) ??
      shortageOfNode(context, session, node, neededBytes);
    if (shortage !== undefined) return shortage;
  }
  return undefined;
}

function shortageOfSession(
  { limits }: LifeContext,
  session: Session,
  neededBytes: number,
): MemoryShortage | undefined {
  const max = limits.moduleBytesPerSession;
  if (neededBytes <= max) return undefined;
  return {
    text: `The session ${quote(session.label)} needs at least ${megabytes(neededBytes)} of memory for its modules on the master; those of one session may have ${megabytes(max)} there. Put some of its modules on other nodes, or raise the limit with --limits moduleBytesPerSession=<bytes>.`,
    limit: 'moduleBytesPerSession',
    details: { neededBytes, max },
  };
}

function shortageOfNode(
  { sessions }: LifeContext,
  session: Session,
  node: Node,
  neededBytes: number,
): MemoryShortage | undefined {
  const max = node.extension?.memoryBytes ?? 0;
  if (max === 0 || neededBytes === 0) return undefined;
  const others = [...sessions()].filter((other) => other !== session);
  const uses = others
    .map((other) => ({ label: other.label, bytes: other.memoryOn(node.id) }))
    .filter(({ bytes }) => bytes > 0)
    .sort((a, b) => b.bytes - a.bytes);
  const usedBytes = uses.reduce((sum, { bytes }) => sum + bytes, 0);
  if (usedBytes + neededBytes <= max) return undefined;
  const named = uses
    .slice(0, MAX_NAMED)
    .map(({ label, bytes }) => `${quote(label)} (${megabytes(bytes)})`);
  const most = named.length === 0 ? '' : ` Most is used by ${named.join(', ')}.`;
  const how = isMaster(node) ? '--limits moduleBytes=<bytes>' : '--memory of that node';
  return {
    text: `The session ${quote(session.label)} needs at least ${megabytes(neededBytes)} of memory for its modules on ${quote(node.label)}; of the ${megabytes(max)} that modules may have there, ${megabytes(usedBytes)} are used.${most} Stop what is not needed, or raise the limit with ${how}.`,
    limit: isMaster(node) ? 'moduleBytes' : undefined,
    details: { neededBytes, max },
  };
}

/** Groups its modules by the nodes that would run them. */
function byNode({ nodes, loadOf }: LifeContext, session: Session): Map<Node, SessionModule[]> {
  const list = nodes.list();
  const found = new Map<Node, SessionModule[]>();
  for (const module of session.modules) {
    const node =
      module.requestedNodeId === undefined
        ? chooseNode(module.spec, list, loadOf)
        : list.find(({ id }) => id === module.requestedNodeId);
    if (node === undefined) continue;
    found.set(node, [...(found.get(node) ?? []), module]);
  }
  return found;
}

function megabytes(bytes: number): string {
  const value = bytes / 1024 / 1024;
  return `${value < 10 ? Math.ceil(value * 10) / 10 : Math.round(value)} MB`;
}
