import { Listeners } from '../callbacks/listeners.ts';
import type { Unsubscribe } from '../callbacks/unsubscribe.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import { ConnectionError } from './connection-error.ts';
import type { Masters } from './masters.ts';
import type { Registration, RegistrationCalls } from './registration.ts';

/** The client went on at another master of the cluster, as itself. */
export interface MasterChange {
  /** Base URL of the master that is its own now, such as `http://10.0.0.6:8080`. */
  readonly url: string;
  /** That of the one it lost. */
  readonly previousUrl: string | undefined;
}

/** Dependencies of moves. */
export interface MovesOptions {
  readonly masters: Masters;
  readonly registration: Pick<Registration, 'switchTo' | 'switchBack' | 'confirmSwitch'>;
  /** Calls of the program. */
  readonly calls: Pick<RegistrationCalls, 'rejectAll'>;
  readonly onError: ErrorHandler;
}

/** The way of a client to another master. [CU-83] */
export class Moves {
  readonly #options: MovesOptions;
  readonly #listeners: Listeners<MasterChange>;
  #lostUrl: string | undefined = undefined;

  constructor(options: MovesOptions) {
    this.#options = options;
    this.#listeners = new Listeners(options.onError);
  }

  onMaster(fn: (change: MasterChange) => void): Unsubscribe {
    return this.#listeners.add(fn);
  }

  switchTo(url: string): void {
    const { masters, registration, calls } = this.#options;
    this.#lostUrl = masters.url;
    calls.rejectAll(
      new ConnectionError(
        'closed',
        'The master was lost before it answered; whether it did what was asked is not known',
      ),
    );
    masters.switchTo(url);
    registration.switchTo();
  }

  switchBack(): void {
    const { masters, registration } = this.#options;
    masters.switchBack();
    registration.switchBack();
  }

  confirmSwitch(): void {
    const { masters, registration } = this.#options;
    masters.confirmSwitch();
    registration.confirmSwitch();
    this.#listeners.emit({ url: masters.url!, previousUrl: this.#lostUrl });
  }
}
