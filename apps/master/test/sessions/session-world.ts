import {
  decodeRecord,
  type ErrorMessage,
  type Init,
  type ProcessingModule,
  type Session,
  type SessionProblem,
} from '@ubii/proto';
import { TestMaster, type TestClient } from '../../src/testing/index.ts';
import type { TestMasterOptions } from '../../src/testing/test-master.ts';

export const TOPICS = {
  add: '/services/session/runtime/add',
  get: '/services/session/runtime/get',
  list: '/services/session/runtime/get_list',
  start: '/services/session/runtime/start',
  stop: '/services/session/runtime/stop',
  update: '/services/session/runtime/update',
  remove: '/services/session/runtime/remove',
  pause: '/services/ubii/session_pause',
  resume: '/services/ubii/session_resume',
  save: '/services/session/database/save',
  stored: '/services/session/database/get_list',
  modules: '/services/processing_module/database/get_list',
  saveModule: '/services/processing_module/database/save',
  deleteModule: '/services/processing_module/database/delete',
  ran: '/services/processing_module/runtime/add',
  ended: '/services/processing_module/runtime/remove',
  nodes: '/services/ubii/node_list',
} as const;

/** A module that puts out twice what it takes, whenever something comes. */
export const doubler = {
  name: 'doubler',
  inputs: [{ internalName: 'in', messageFormat: 'double' }],
  outputs: [{ internalName: 'out', messageFormat: 'double' }],
  processingMode: { triggerOnInput: {} },
  onProcessingStringified:
    '(deltaTime, inputs) => inputs.in ? { outputs: { out: { double: 2 * inputs.in.double } } } : {}',
} satisfies Init<ProcessingModule>;

/** The doubler from one topic to another. */
export function doubling(from: string, to: string): Init<Session> {
  return {
    name: 'doubling',
    processingModules: [doubler],
    ioMappings: [
      {
        processingModuleName: 'doubler',
        inputMappings: [{ inputName: 'in', topic: from }],
        outputMappings: [{ outputName: 'out', topic: to }],
      },
    ],
  };
}

/** A master with a client that subscribes to sessions. */
export class SessionWorld {
  readonly master: TestMaster;
  readonly ada: TestClient;
  readonly news: [topic: string, session: Session][] = [];

  private constructor(master: TestMaster, ada: TestClient) {
    this.master = master;
    this.ada = ada;
  }

  static async create(options: TestMasterOptions = {}): Promise<SessionWorld> {
    const master = new TestMaster(options);
    const ada = await master.extension('ada');
    const world = new SessionWorld(master, ada);
    await ada.subscribe({ subscribeTopicRegexp: ['^/info/session/'] });
    return world;
  }

  /** Asks for something about a session, and lets what follows happen. @throws Error when it is refused */
  async ask(topic: string, session: Init<Session> = {}): Promise<Session> {
    const reply = await this.master.call({ topic, session });
    if (reply.error) throw new Error(`${reply.error.code}: ${reply.error.message}`);
    await this.master.pass();
    return reply.session!;
  }

  /** Why it is refused. */
  async refusal(topic: string, session: Init<Session> = {}): Promise<ErrorMessage> {
    const { error } = await this.master.call({ topic, session });
    if (error === undefined) throw new Error('it was not refused');
    return error;
  }

  /** The session as it is now. */
  async get({ id }: Pick<Session, 'id'>): Promise<Session> {
    return this.ask(TOPICS.get, { id });
  }

  /** News of sessions since they were asked for last, as topic and session. */
  takeNews(): [topic: string, session: Session][] {
    return this.ada.takeSent().flatMap((sent) => {
      const records =
        sent.kind === 'record' ? [sent.record] : sent.kind === 'list' ? sent.records : [];
      return records.flatMap((bytes): [string, Session][] => {
        const { topic, format, value } = decodeRecord(bytes);
        return format === 'session' ? [[topic.replace('/info/session/', ''), value]] : [];
      });
    });
  }

  /** Events of sessions since the last call. */
  takeWords(): string[] {
    return this.takeNews().map(([word]) => word);
  }

  /** The newest value of a topic. */
  async value(topic: string): Promise<unknown> {
    const reader = await this.master.extension('reader');
    await reader.subscribe({ subscribeTopics: [topic] });
    await this.master.pass();
    const value = reader.takeRecords().at(-1)?.value;
    await this.master.call({
      topic: '/services/client/deregistration',
      client: { id: reader.id },
    });
    return value;
  }
}

/** Codes of problems. */
export function codes(problems: readonly SessionProblem[] = []): string[] {
  return problems.map(({ code }) => code);
}
