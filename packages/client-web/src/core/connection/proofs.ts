import type { MasterAt } from '../ports/master-ways.ts';
import type { Identity } from './identity.ts';
import type { askForProof, ProofUnderWay } from './master-proof.ts';

/**
 * Asks masters for proofs, with code that is loaded when the client learns of other masters: most pages never do, and
 * when the master is lost, it is too late. [CU-85]
 */
export class Proofs {
  #ask: typeof askForProof | undefined;

  /** Does nothing once it is loaded; a load that fails is tried again the next time. */
  load(): void {
    if (this.#ask !== undefined) return;
    void import('./master-proof.ts').then(
      (loaded) => (this.#ask = loaded.askForProof),
      () => undefined,
    );
  }

  ask(master: MasterAt, identity: Identity | undefined, nonce: string): ProofUnderWay {
    return this.#ask?.(master, identity, nonce) ?? UNPROVEN;
  }
}

const UNPROVEN: ProofUnderWay = { isProven: Promise.resolve(false), cancel: () => undefined };
