import { isIpAddress, isLoopbackHost, isPrivateAddress } from '../addresses/address-kinds.ts';

export interface OriginPolicyOptions {
  /** Whether other machines can reach the master now. */
  readonly isOnLan: () => boolean;
  /** Name the master was told to listen on. */
  readonly host: string;
  /** Origins of the configuration, see `allowedOrigins` in config.ts. */
  readonly allowedOrigins: readonly string[];
  /** Address of the operator, by whose name the master may be called; its pages are those of any machine. [SV-13] */
  readonly publicUrl?: string | undefined;
  /**
   * Whether an address is one of this machine. Programs here call themselves by what their hostname
   * resolves to (the Python node does), which is no loopback address everywhere. @default never
   */
  readonly isOwnAddress?: (address: string) => boolean;
  /**
   * Origins of the other masters of the cluster. Their pages may call: their clients come here when their master is
   * lost. They are no pages of this machine, and show who they are as those of other machines do. [CU-90] @default none
   */
  readonly clusterOrigins?: () => readonly string[];
}

/** Decision about a request, from headers that browsers set and pages cannot change. */
export type OriginVerdict =
  | { readonly kind: 'same-origin' }
  | { readonly kind: 'allowed'; readonly origin: string }
  /** Of a page that has no name: who shows a token of its own may call. */
  | { readonly kind: 'nameless'; readonly reason: string }
  | { readonly kind: 'refused'; readonly reason: string };

/** Owner of a page, for a request of this machine: this master, a configured origin, or another one. */
export type PageKind = 'own' | 'named' | 'foreign';

const NAMELESS =
  'A page that was opened from a file or runs in an isolated frame may use this master only with its own token. Create an invitation for it, and send its token as Authorization: Bearer.';

/**
 * Decides which web pages may talk to this master. [SV-8]
 *
 * Two attacks are kept out: a page of another origin that calls the services of a visitor's own
 * machine, and a page whose name was re-bound to this machine's address, so that the browser takes
 * it for the same origin. Programs that are no browsers send no Origin and are admitted.
 */
export class OriginPolicy {
  readonly #options: OriginPolicyOptions;
  readonly #patterns: readonly RegExp[];
  readonly #publicName: string | undefined;
  /** The origins with a name. */
  readonly #named: readonly RegExp[];
  /** Every page may call, those without a name as well. */
  readonly #isOpen: boolean;

  constructor(options: OriginPolicyOptions) {
    this.#options = options;
    this.#publicName = options.publicUrl && new URL(options.publicUrl).hostname;
    this.#patterns = options.allowedOrigins.map(patternOf);
    this.#isOpen = options.allowedOrigins.includes('*');
    this.#named = options.allowedOrigins.filter((origin) => origin !== '*').map(patternOf);
  }

  /** @param headers as received; Host is missing only in requests of very old programs */
  judge(headers: { readonly host?: string; readonly origin?: string }): OriginVerdict {
    const host = headers.host?.toLowerCase();
    if (host !== undefined && !this.#isOurHost(host)) {
      return {
        kind: 'refused',
        reason: `The hostname "${host.slice(0, 200)}" is not allowed. Open the master by its address, or start it with --allowed-origins http://${host.slice(0, 200)}.`,
      };
    }
    const origin = headers.origin?.toLowerCase();
    if (origin === undefined || origin === `http://${host}` || origin === `https://${host}`) {
      return { kind: 'same-origin' };
    }
    if (origin === 'null' && !this.#isOpen) {
      return { kind: 'nameless', reason: NAMELESS };
    }
    if (this.#isAllowed(origin)) return { kind: 'allowed', origin: headers.origin ?? origin };
    return {
      kind: 'refused',
      reason: `Pages of ${origin.slice(0, 200)} may not use this master. Start it with --allowed-origins ${origin.slice(0, 200)} to allow them.`,
    };
  }

  /**
   * Returns the owner of the page of a local request: this master or a program, an origin that the operator
   * named, or another one. Only names that no other machine can claim are trusted: loopback names,
   * and loopback and own addresses. Other names, of the master and of pages, do not. [AC-1] [AC-2]
   */
  pageOf(headers: {
    readonly host?: string;
    readonly origin?: string;
    readonly 'sec-fetch-site'?: string | readonly string[] | undefined;
  }): PageKind {
    const host = headers.host?.toLowerCase();
    if (host !== undefined && !this.#isOwnHost(hostNameOf(host))) return 'foreign';
    const origin = headers.origin?.toLowerCase();
    // Programs send neither; browsers leave the origin out of what a link or a picture asks for.
    if (origin === undefined) {
      return /^(cross|same)-site$/.test(String(headers['sec-fetch-site'])) ? 'foreign' : 'own';
    }
    if (!/^https?:\/\//.test(origin)) return 'foreign';
    const name = hostNameOf(origin.replace(/^https?:\/\//, ''));
    if (this.#isOwnHost(name)) return 'own';
    // Over HTTP, the network decides which machine a name means.
    const isProven = origin.startsWith('https:') || isIpAddress(name);
    return isProven && this.#isNamed(origin) ? 'named' : 'foreign';
  }

  #isOwnHost(name: string): boolean {
    return isLoopbackHost(name) || this.#isOwnIp(name);
  }

  #isOwnIp(name: string): boolean {
    return isIpAddress(name) && this.#options.isOwnAddress?.(name) === true;
  }

  /** The operator named this origin, and not all of them. */
  #isNamed(origin: string): boolean {
    return this.#named.some((pattern) => pattern.test(origin));
  }

  #isAllowed(origin: string): boolean {
    if (this.#patterns.some((pattern) => pattern.test(origin))) return true;
    if (!/^https?:\/\//.test(origin)) return false;
    const name = hostNameOf(origin.replace(/^https?:\/\//, ''));
    const { isOnLan, isOwnAddress, clusterOrigins, publicUrl } = this.#options;
    return (
      // Proxies may leave the port out of Host.
      origin === publicUrl ||
      isLoopbackHost(name) ||
      (isOnLan() && isPrivateAddress(name)) ||
      (isIpAddress(name) && isOwnAddress?.(name) === true) ||
      clusterOrigins?.().includes(origin) === true
    );
  }

  /**
   * Addresses cannot be re-bound. Names that cannot be registered in the public name
   * system are safe; other names must be configured.
   */
  #isOurHost(host: string): boolean {
    const name = hostNameOf(host);
    return (
      isIpAddress(name) ||
      isLoopbackHost(name) ||
      !name.includes('.') ||
      /\.(local|lan|internal|home\.arpa)$/.test(name) ||
      name === this.#options.host ||
      name === this.#publicName ||
      this.#patterns.some(
        (pattern) => pattern.test(`http://${host}`) || pattern.test(`https://${host}`),
      )
    );
  }
}

/** `[::1]:8080` -> `::1`, `example.org:80` -> `example.org` */
function hostNameOf(host: string): string {
  return host
    .replace(/:\d*$/, '')
    .replace(/^\[(.*)\]$/, '$1')
    .replace(/\.$/, '');
}

function patternOf(origin: string): RegExp {
  if (origin === '*') return /^/;
  const source = origin
    .replace(/[.[\]?+^$(){}|\\/-]/g, '\\$&')
    .replace(/:\*$/, '(:\\d+)?')
    .replace('*\\.', '([a-z0-9-]+\\.)+');
  // eslint-disable-next-line ubii/no-native-patterns -- the operator's, escaped; each level ends with a dot no level contains
  return new RegExp(`^${source}$`);
}
