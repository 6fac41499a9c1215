import {
  ModuleEventKind,
  type EndedTopics,
  type ModuleEvent,
  type ModuleReports,
} from '@ubii/proto';
import { readNodeMessage } from '@ubii/proto/wire';
import type { Clock } from '@ubii/timing';
import type { Client } from '../clients/client.ts';
import type { Limits } from '../limits/index.ts';
import { cutTexts } from '../texts/bound-texts.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { Lockstep } from './lockstep/lockstep.ts';
import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';
import type { SessionNews } from './session-news.ts';
import type { SessionTable } from './session-table.ts';

/** What node messages are for. */
export interface NodeReportsContext {
  readonly limits: Limits;
  readonly table: SessionTable;
  readonly news: SessionNews;
  readonly lockstep: Lockstep;
  readonly clock: Clock;
  readonly topics: TopicTable;
  /** A module has told something. */
  readonly onEvent: (session: Session, module: SessionModule, event: ModuleEvent) => void;
  /** A module could not be made, or was given up [SE-12]. */
  readonly onFailed: (nodeId: string, event: ModuleEvent) => void;
}

/** Takes what nodes say over their sockets: answers of passes, and how their modules do [EX-20]. */
export class NodeReports {
  readonly #context: NodeReportsContext;

  constructor(context: NodeReportsContext) {
    this.#context = context;
  }

  /** @throws DecodeError when the bytes are no message of a node */
  handleMessage(client: Client, bytes: Uint8Array): void {
    const { lockstepReply, moduleReports, endedTopics } = readNodeMessage(bytes);
    if (lockstepReply !== undefined) {
      const { sessionId, pass } = lockstepReply.head;
      // The frame may be reused for something else before all have answered.
      const records = lockstepReply.records.map((record) => record.slice());
      this.#context.lockstep.handleReply(client.id, sessionId, pass, records);
    }
    if (moduleReports !== undefined) this.#takeReports(client, moduleReports);
    if (endedTopics !== undefined) this.#endTopics(client, endedTopics);
  }

  /** An event of a module, from whichever node [SE-51]. */
  handleEvent(nodeId: string, event: ModuleEvent): void {
    const found = this.#context.table.findModule(event.moduleId);
    // Ignore reports about modules of other nodes.
    if (found === undefined || found.module.nodeId !== nodeId) return;
    const { session, module } = found;
    const told = {
      ...cutTexts('ubii.extension.ModuleEvent', event, this.#context.limits),
      sessionId: session.id,
      moduleName: module.name,
      nodeId,
    };
    this.#context.news.publishEvent(told);
    this.#context.onEvent(session, module, told);
  }

  /** [SE-63] */
  #endTopics(client: Client, { topics }: EndedTopics): void {
    const { topics: table, clock } = this.#context;
    for (const topic of topics) {
      if (!client.recordBudget.take(1, clock.monotonicMs())) return;
      const entry = table.get(topic);
      // A node cannot delete values of other publishers.
      if (entry?.owner === client) table.deleteValue(entry);
    }
  }

  /** [PM-80] [PM-81] */
  #takeReports(client: Client, { statistics, events }: ModuleReports): void {
    for (const one of statistics) {
      const module = this.#context.table.findModule(one.moduleId)?.module;
      if (module?.nodeId === client.id) {
        const bounded = cutTexts('ubii.extension.ModuleStatistics', one, this.#context.limits);
        module.noteStatistics(
          { ...bounded, nodeId: client.id, moduleName: module.name },
          this.#context.clock.monotonicMs(),
        );
      }
    }
    for (const told of events) {
      // What a node has to say counts like what it publishes.
      if (!client.recordBudget.take(1, this.#context.clock.monotonicMs())) return;
      const event = cutTexts('ubii.extension.ModuleEvent', told, this.#context.limits);
      this.handleEvent(client.id, event);
      if (event.kind === ModuleEventKind.FAILED) this.#context.onFailed(client.id, event);
    }
  }
}
