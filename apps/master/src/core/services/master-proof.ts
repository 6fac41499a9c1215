import { masterHost, masterProofText, ServiceError } from '@ubii/proto';
import { definer } from './define-service.ts';

/** Random and unique: long enough for that, and short enough to be signed for any caller. */
const NONCE = /^[!-~]{16,64}$/;

/**
 * Proves to a client that this master is of its cluster, before the client shows its token. [CU-85]
 *
 * A caller that used another address gets a proof of no address, as long as any other: it is worth nothing to a server that
 * passes the question on, and tells a stranger of no network. [AC-5]
 */
export const masterProof = definer<'settings' | 'tokens'>()('masterProof', {
  roles: 'anyone',
  handle({ settings, tokens }, { targetId, host, nonce }) {
    if (!NONCE.test(nonce)) {
      throw new ServiceError(
        'invalid_argument',
        'Expected a nonce of 16 to 64 characters of ASCII without spaces.',
      );
    }
    const own = settings.endpoints().addresses.map(({ url }) => masterHost(url ?? ''));
    const proven = own.includes(host) ? host : '';
    const text = masterProofText({ host: proven, clientId: targetId, nonce });
    return { proof: tokens.prove(targetId, text) };
  },
});
