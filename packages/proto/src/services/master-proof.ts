/** What a proof is about. [CU-85] */
export interface MasterProofFacts {
  /** Host and port of the master, as `masterHost` gives them. */
  readonly host: string;
  readonly clientId: string;
  readonly nonce: string;
}

/** Tells this text from all others that are signed with the same key. */
const PURPOSE = 'ubi-interact master proof 1';

/** The text that a master signs with the resume token of a client, to prove that it is of the cluster. [CU-85] */
export function masterProofText({ host, clientId, nonce }: MasterProofFacts): string {
  return [PURPOSE, host, clientId, nonce].join('\n');
}

/**
 * Host and port of a web address: the same for HTTP and HTTPS, which a master has on one port.
 * @returns undefined when it is none
 */
export function masterHost(url: string): string | undefined {
  if (!/^https?:/i.test(url)) return undefined;
  try {
    const { hostname, port, protocol } = new URL(url);
    return `${hostname}:${port || (protocol === 'https:' ? '443' : '80')}`;
  } catch {
    return undefined;
  }
}
