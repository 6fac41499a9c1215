import { INFO_TOPICS } from '@ubii/proto';
import type { Session } from '@ubii/proto';
import type { Subscription } from '../core/subscriptions/subscription.ts';
import type { UbiiClient } from '../core/client/ubii-client.ts';
import { activityOf } from './session-modules.ts';
import type { SessionActivity } from './session-modules.ts';

/** Dependencies of the watch on a client. */
export type SessionClient = Pick<UbiiClient, 'subscribe' | 'call' | 'onState' | 'state'>;

/** Callbacks of the watch. */
export interface SessionWatchOptions {
  /** Called with the current state of a session. */
  readonly handleSession: (session: Session, activity: SessionActivity) => void;
  /** A session starts, whether or not something of it runs already. */
  readonly handleStart: (session: Session) => void;
  /** A session was deleted: it is over, and what it made ends. */
  readonly handleDeleted: (session: Session) => void;
  /** All sessions there are; those that are missing are no more. */
  readonly handleAll: (sessions: readonly Session[]) => void;
}

/**
 * Keeps track of the sessions of the master: by its announcements, and by its list at every
 * connection. Announcements that come while the list is on its way may be newer or older than it: the
 * master sends the last one of each topic again, however long ago it was. So the list is asked for
 * again until nothing comes in between. [PM-62]
 */
export class SessionWatch {
  readonly #client: SessionClient;
  readonly #options: SessionWatchOptions;
  readonly #subscriptions: readonly Subscription<'session'>[];
  readonly #stopListening: () => void;
  /** The list is on its way. */
  #isReading = false;
  /** Something came meanwhile. */
  #isStale = false;
  #isClosed = false;

  constructor(client: SessionClient, options: SessionWatchOptions) {
    this.#client = client;
    this.#options = options;
    const on = (topic: string, handle: (session: Session) => void) =>
      client.subscribe(topic, { format: 'session' }).onRecord(({ value }) => {
        if (this.#isReading) this.#isStale = true;
        // The list follows and replaces messages that arrive while the client connects.
        else if (!this.#isClosed && client.state.status === 'connected') handle(value);
      });
    const { handleSession, handleStart, handleDeleted } = options;
    this.#subscriptions = [
      on(INFO_TOPICS.startSession, handleStart),
      on(INFO_TOPICS.changeSession, (session) => {
        const activity = activityOf(session);
        if (activity !== undefined) handleSession(session, activity);
      }),
      on(INFO_TOPICS.stopSession, (session) => handleSession(session, 'over')),
      on(INFO_TOPICS.deleteSession, handleDeleted),
    ];
    this.#stopListening = client.onState(({ status }) => {
      if (status === 'connected') this.refresh();
    });
    if (client.state.status === 'connected') this.refresh();
  }

  /** Reads the list of sessions. */
  refresh(): void {
    this.#isStale = true;
    if (this.#isReading || this.#isClosed) return;
    this.#isReading = true;
    void this.#read().finally(() => {
      this.#isReading = false;
    });
  }

  close(): void {
    this.#isClosed = true;
    this.#stopListening();
    for (const subscription of this.#subscriptions) void subscription.close();
  }

  async #read(): Promise<void> {
    while (this.#isStale && !this.#isClosed) {
      this.#isStale = false;
      try {
        await Promise.all(this.#subscriptions.map(({ ready }) => ready));
        const { elements } = await this.#client.call('sessionRuntimeGetList');
        if (!this.#isClosed) this.#options.handleAll(elements);
      } catch {
        return; // the next connection brings another try
      }
    }
  }
}
