import type { ClientOptions } from './core/client/client-options.ts';

/** URLs of a master. */
export interface Endpoints {
  readonly servicesUrl: string;
  readonly topicDataUrl: string;
}

/**
 * The addresses the options mean.
 * @param defaultUrl origin of the page, if there is one
 * @throws {TypeError} if they name no master, or are no addresses
 */
export function resolveEndpoints(
  options: Pick<ClientOptions, 'url' | 'servicesUrl' | 'topicDataUrl'>,
  defaultUrl: string | undefined,
): Endpoints {
  const { url = defaultUrl, servicesUrl, topicDataUrl } = options;
  return {
    servicesUrl: parse('servicesUrl', servicesUrl ?? under(url, '/services/binary')).href,
    topicDataUrl: toWebSocket(parse('topicDataUrl', topicDataUrl ?? under(url, '/topicdata'))).href,
  };
}

function under(url: string | undefined, path: string): string {
  if (url === undefined) {
    throw new TypeError(
      'Expected "url", or both "servicesUrl" and "topicDataUrl", received neither',
    );
  }
  return `${url.replace(/\/+$/, '')}${path}`;
}

function parse(name: string, text: string): URL {
  try {
    return new URL(text);
  } catch (cause) {
    throw new TypeError(`Expected an absolute URL for "${name}", received "${text}"`, { cause });
  }
}

function toWebSocket(url: URL): URL {
  if (url.protocol === 'http:') url.protocol = 'ws:';
  if (url.protocol === 'https:') url.protocol = 'wss:';
  return url;
}
