import type { Mapping } from '../core/mapping/mapping.ts';
import type { ForeignEvents, ForeignMessage, ForeignState } from '../core/ports/foreign-system.ts';
import { Inbox } from './inbox.ts';

/** True once the adapter is connected. */
export const isConnected = ({ status }: ForeignState): boolean => status === 'connected';

/** Keeps what an adapter reports. */
export class SystemEvents<P> implements ForeignEvents<P> {
  readonly messages = new Inbox<ForeignMessage<P>>();
  readonly states = new Inbox<ForeignState>();
  readonly settled = new Inbox<'settled'>();
  /** Why messages were refused or dropped. */
  readonly refused = new Inbox<string>();
  count = 0;

  handleMessage(message: ForeignMessage<P>): void {
    this.count++;
    this.messages.add(message);
  }

  handleRefused(reason: string): void {
    this.refused.add(reason);
  }

  handleDropped(_mapping: Mapping, reason: string): void {
    this.refused.add(reason);
  }

  handleState(state: ForeignState): void {
    this.count++;
    this.states.add(state);
  }

  handleSettled(): void {
    this.count++;
    this.settled.add('settled');
  }
}
