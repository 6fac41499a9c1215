import { chooseNode } from '../nodes/placement.ts';
import { isMaster, type Node } from '../nodes/node.ts';
import type { LimitName } from '../limits/index.ts';
import { quote } from '../texts/quote.ts';
import type { LifeContext } from './life-context.ts';
import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';

/** Why a session cannot be started now. */
export interface MemoryShortage {
  /** Sentences for people. */
  readonly text: string;
  /** The limit that is met, when it is one of the master's. */
  readonly limit: LimitName | undefined;
  readonly details: { readonly neededBytes: number; readonly max: number };
}

/** Sessions that are named as those that use most. */
const NAMED = 3;

/** Looks whether the nodes of a session have the memory that its modules need at least [SE-64]. */
export function memoryShortage(context: LifeContext, session: Session): MemoryShortage | undefined {
  for (const [node, modules] of byNode(context, session)) {
    const neededBytes = modules.reduce((sum, module) => sum + module.leastMemoryBytes, 0);
    const short =
      (isMaster(node) ? ofSession(context, session, neededBytes) : undefined) ??
      ofNode(context, session, node, neededBytes);
    if (short !== undefined) return short;
  }
  return undefined;
}

function ofSession(
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

function ofNode(
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
    .slice(0, NAMED)
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
      module.wishedNodeId === ''
        ? chooseNode(module.spec, list, loadOf)
        : list.find(({ id }) => id === module.wishedNodeId);
    if (node === undefined) continue;
    found.set(node, [...(found.get(node) ?? []), module]);
  }
  return found;
}

function megabytes(bytes: number): string {
  const value = bytes / 1024 / 1024;
  return `${value < 10 ? Math.ceil(value * 10) / 10 : Math.round(value)} MB`;
}
