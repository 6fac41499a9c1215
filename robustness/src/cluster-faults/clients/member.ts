import { createClient, type UbiiClient } from '@ubii/client-web/node';

import { Reception } from './reception.ts';

/** Where a member joins, and what it does. */
export interface MemberPlan {
  readonly url: string;
  readonly joinToken: string;
  readonly name: string;
  /** Topics that it subscribes to. */
  readonly topics: readonly string[];
  /** Topic that it publishes on, if any. */
  readonly publishes: string | undefined;
}

/** One client of a pool: it receives numbers, and publishes some. */
export class Member {
  readonly #client: UbiiClient;
  readonly #plan: MemberPlan;
  readonly receptions: readonly Reception[];
  #id = '';
  #last = 0;
  #home = '';
  #hasMoved = false;
  #identityChanges = 0;

  constructor(plan: MemberPlan) {
    this.#plan = plan;
    const { url, joinToken, name } = plan;
    this.#client = createClient({ url, joinToken, name, publishIntervalMs: 0 });
    this.receptions = plan.topics.map((topic) => new Reception(topic));
    this.#client.onState(({ status }) => {
      if (status !== 'connected') this.#hasMoved = true;
    });
    this.#client.onMaster(() => (this.#hasMoved = true));
    this.#client.onIdentityChange(() => (this.#identityChanges += 1));
  }

  get id(): string {
    return this.#id;
  }

  /** Times that its identity changed. */
  get identityChanges(): number {
    return this.#identityChanges;
  }

  get isConnected(): boolean {
    return this.#client.state.status === 'connected';
  }

  /** Where it is and what it does, in words. */
  get situation(): string {
    const { state, masterUrl } = this.#client;
    const error = 'error' in state && state.error !== undefined ? `: ${state.error.message}` : '';
    return `${state.status} at ${masterUrl}${error}`;
  }

  /** Number of other masters that it knows. */
  get knownMasters(): number {
    return this.#client.otherMasters.length;
  }

  get publishes(): string | undefined {
    return this.#plan.publishes;
  }

  /** Number of the last record that it published. */
  get last(): number {
    return this.#last;
  }

  /** URL of the master it was at when this phase of the run began. */
  get home(): string {
    return this.#home;
  }

  get hasMoved(): boolean {
    return this.#hasMoved;
  }

  async join(): Promise<void> {
    await this.#client.connect();
    this.#id = this.#client.id;
    await Promise.all(
      this.receptions.map(
        (reception) =>
          this.#client
            .subscribe(reception.topic, { format: 'double' })
            .onRecord(({ value }) => reception.handle(value)).ready,
      ),
    );
  }

  publishNext(): void {
    const { publishes } = this.#plan;
    if (publishes !== undefined) this.#client.publish(publishes, 'double', ++this.#last);
  }

  /** A phase of the run begins. */
  begin(): void {
    this.#home = this.#client.masterUrl ?? '';
    this.#hasMoved = !this.isConnected;
  }

  close(): Promise<void> {
    return this.#client.close();
  }
}
