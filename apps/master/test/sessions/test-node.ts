import {
  decodeRecord,
  NodeExtensionKind,
  type Client,
  type Init,
  type ProcessingModule,
  type ServiceReply,
  type Session,
} from '@ubii/proto';
import type { TestClient, TestMaster } from '../../src/testing/index.ts';
import { TOPICS } from './session-world.ts';

/** Registration of a node of this project. */
export const OUR_NODE = {
  kind: NodeExtensionKind.NODE,
  runsJavascript: true,
  acceptsWork: true,
  libraries: [],
  capacity: 10,
} as const;

/** A client that runs modules, as far as messages go: the test says what it reports. */
export class TestNode {
  readonly client: TestClient;
  readonly #master: TestMaster;

  private constructor(master: TestMaster, client: TestClient) {
    this.#master = master;
    this.client = client;
  }

  /** A node of ours. */
  static async ours(
    master: TestMaster,
    name: string,
    client: Init<Client> = {},
  ): Promise<TestNode> {
    const registered = await master.register({
      name,
      extension: { recordLists: true, node: OUR_NODE },
      ...client,
    });
    registered.open();
    return TestNode.#listening(master, registered);
  }

  /** A node of the original: subscribes before its socket is open, one topic a request. */
  static async original(
    master: TestMaster,
    name: string,
    client: Init<Client> = {},
  ): Promise<TestNode> {
    const registered = await master.register({
      name,
      isDedicatedProcessingNode: true,
      ...client,
    });
    const node = await TestNode.#listening(master, registered);
    registered.open();
    return node;
  }

  static async #listening(master: TestMaster, client: TestClient): Promise<TestNode> {
    await client.subscribe({ subscribeTopics: ['/info/session/start'] });
    await client.subscribe({ subscribeTopics: ['/info/session/stop'] });
    if (client.registered.extension !== undefined) {
      await client.subscribe({ subscribeTopics: ['/info/session/change'] });
    }
    client.takeSent();
    return new TestNode(master, client);
  }

  get id(): string {
    return this.client.id;
  }

  /** Announced sessions since the last call, as word and session. */
  takeNews(): [word: string, session: Session][] {
    return this.client.takeSent().flatMap((sent) => {
      const records =
        sent.kind === 'record' ? [sent.record] : sent.kind === 'list' ? sent.records : [];
      return records.flatMap((bytes): [string, Session][] => {
        const { topic, format, value } = decodeRecord(bytes);
        return format === 'session' ? [[topic.replace('/info/session/', ''), value]] : [];
      });
    });
  }

  /** The newest session announced with this word. */
  told(word: string): Session {
    const news = this.takeNews().findLast(([topic]) => topic === word);
    if (news === undefined) throw new Error(`it was not told to ${word}`);
    return news[1];
  }

  /** Its modules of a session. */
  own({ processingModules }: Session): ProcessingModule[] {
    return processingModules.filter(({ nodeId }) => nodeId === this.id);
  }

  /** Lets time pass while the node answers, as one that is there does. */
  async pass(durationMs: number): Promise<void> {
    for (let passedMs = 0; passedMs < durationMs; passedMs += 1000) {
      this.client.sendText('PONG');
      await this.#master.pass(Math.min(1000, durationMs - passedMs));
    }
  }

  /** Says that modules run. */
  async ran(modules: readonly Init<ProcessingModule>[]): Promise<ServiceReply> {
    return this.#report(TOPICS.ran, modules);
  }

  /** Says that modules have ended. */
  async ended(modules: readonly Init<ProcessingModule>[]): Promise<ServiceReply> {
    return this.#report(TOPICS.ended, modules);
  }

  async #report(topic: string, elements: readonly Init<ProcessingModule>[]): Promise<ServiceReply> {
    const reply = await this.#master.call({ topic, processingModuleList: { elements } });
    await this.#master.pass();
    return reply;
  }
}
