import { StatusEventKind } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { Log } from '../ports/log.ts';
import type { EventLog } from '../counters/event-log.ts';
import type { BrokenDocument, StoredMessages } from './stored-messages.ts';

/** Dependencies of the notifications about stored documents. */
export interface FileNewsContext {
  readonly log: Log;
  readonly events: EventLog;
}

/** Names documents that cannot be read, when the master starts and when their files change [SE-23]. */
export class FileNews {
  readonly #context: FileNewsContext;
  readonly #stores: readonly Pick<StoredMessages<never>, 'store' | 'broken'>[];
  readonly #cancels: readonly Cancel[];
  /** Broken documents, with the reported reason. */
  #told = new Map<string, string>();

  constructor(
    context: FileNewsContext,
    stores: readonly Pick<StoredMessages<never>, 'store' | 'broken'>[],
  ) {
    this.#context = context;
    this.#stores = stores;
    this.#look();
    this.#cancels = stores.map(({ store }) => store.onChange(() => this.#look()));
  }

  /** Documents that cannot be read. */
  broken(): BrokenDocument[] {
    return this.#stores.flatMap((store) => store.broken());
  }

  close(): void {
    for (const cancel of this.#cancels) cancel();
  }

  #look(): void {
    const { log, events } = this.#context;
    const broken = new Map(this.broken().map(({ where, reason }) => [where, reason]));
    for (const [where, reason] of broken) {
      if (this.#told.get(where) === reason) continue;
      log.warn('a file cannot be read and is ignored', { file: where, reason });
      events.add(StatusEventKind.FILE_BROKEN, `${where} cannot be read: ${reason}`);
    }
    for (const where of this.#told.keys()) {
      if (broken.has(where)) continue;
      log.info('a file can be read again', { file: where });
      events.add(StatusEventKind.FILE_CHANGED, `${where} can be read again, or was removed`);
    }
    this.#told = broken;
  }
}
