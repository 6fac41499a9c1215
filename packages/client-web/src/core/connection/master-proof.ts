import { hmac } from '@noble/hashes/hmac.js';
import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex, utf8ToBytes } from '@noble/hashes/utils.js';
import { masterHost, masterProofText, SERVICES } from '@ubii/proto';
import type { MasterAt } from '../ports/master-ways.ts';
import type { Identity } from './identity.ts';

/** A master is being asked to prove that it is of the cluster of the client. */
export interface ProofUnderWay {
  /** Whether it could; `false` as well when it did not answer. Does not reject. */
  readonly isProven: Promise<boolean>;
  /** Gives up waiting. */
  cancel(): void;
}

/**
 * Asks a master to prove that it is of the cluster, without showing it a secret: only a master with the key of the
 * cluster knows the resume token of the client, with which the answer is signed. The signed text has the address that is
 * asked, so that the answer of a real master elsewhere is worth nothing here, and a nonce against answers of earlier
 * questions. WebCrypto would be there in secure contexts only. [CU-85]
 * @param nonce random, another one each time
 */
export function askForProof(
  { url = '', services }: MasterAt,
  identity: Identity | undefined,
  nonce: string,
): ProofUnderWay {
  const host = masterHost(url);
  const token = identity?.resumeToken;
  if (identity === undefined || token === undefined || host === undefined) return UNPROVEN;
  const { clientId } = identity;
  const exchange = services.send({
    topic: SERVICES.masterProof.topic,
    masterProofRequest: { targetId: clientId, host, nonce },
  });
  const text = masterProofText({ host, clientId, nonce });
  return {
    isProven: exchange.reply.then(
      ({ masterProof }) => isEqual(masterProof?.proof ?? '', proofOf(token, text)),
      () => false,
    ),
    cancel: () => exchange.cancel(),
  };
}

/** As the master computes it. */
export function proofOf(resumeToken: string, text: string): string {
  return bytesToHex(hmac(sha256, utf8ToBytes(resumeToken), utf8ToBytes(text)));
}

const UNPROVEN: ProofUnderWay = { isProven: Promise.resolve(false), cancel: () => undefined };

/** Takes the same time wherever the texts differ. */
function isEqual(given: string, expected: string): boolean {
  if (given.length !== expected.length) return false;
  let difference = 0;
  for (let i = 0; i < expected.length; i++) {
    difference |= given.charCodeAt(i) ^ expected.charCodeAt(i);
  }
  return difference === 0;
}
