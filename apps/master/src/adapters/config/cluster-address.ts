import { parseList } from '@ubii/program';

/** Where the NATS servers of a cluster are, and what masters identify themselves with. */
export interface ClusterAddress {
  /** `nats://host:port` or `tls://host:port`, without secrets. */
  readonly servers: readonly string[];
  /** With TLS: all of them or none. */
  readonly isEncrypted: boolean;
  /** From the address. A user without a password is a token, as NATS has it. */
  readonly login?:
    | { readonly user: string; readonly password: string }
    | { readonly token: string };
}

const EXPECTED = 'addresses of NATS servers, such as nats://10.0.0.7:4222,nats://10.0.0.8:4222';

/** @throws Error whose message is what was expected; it never has the text itself, which may hold a password */
export function parseCluster(text: string): ClusterAddress {
  const urls = parseList(text).map(parseServer);
  const [first] = urls;
  if (first === undefined) throw new Error(EXPECTED);
  const isSame = (url: URL): boolean =>
    url.protocol === first.protocol &&
    url.username === first.username &&
    url.password === first.password;
  if (!urls.every(isSame)) {
    throw new Error('addresses with the same scheme, user and password');
  }
  const login = loginOf(first);
  return {
    servers: urls.map(({ protocol, hostname, port }) => `${protocol}//${hostname}:${port || 4222}`),
    isEncrypted: first.protocol === 'tls:',
    ...(login && { login }),
  };
}

/** Lower-case letters, digits and hyphens: the name is part of subjects and of names of stores. */
export function parseClusterName(text: string): string {
  if (/^[a-z0-9][a-z0-9-]{0,31}$/.test(text)) return text;
  throw new Error('1 to 32 lower-case letters, digits and hyphens');
}

function parseServer(text: string): URL {
  const url = URL.canParse(text) ? new URL(text) : undefined;
  const isPlain = url !== undefined && /^\/?$/.test(url.pathname) && !url.search && !url.hash;
  if (!isPlain || !/^(nats|tls):$/.test(url.protocol) || url.hostname === '') {
    throw new Error(EXPECTED);
  }
  return url;
}

function loginOf({ username, password }: URL): ClusterAddress['login'] {
  if (username === '') return undefined;
  const user = decodeURIComponent(username);
  return password === '' ? { token: user } : { user, password: decodeURIComponent(password) };
}
