import page from './out-of-reach.html?raw';
import style from './out-of-reach.css?inline';

/* Shows a message that the master is unreachable, instead of the browser's error page. Does nothing else: no
   caching, and only navigation requests are handled. */

interface LifeEvent extends Event {
  waitUntil(done: Promise<unknown>): void;
  /** https://www.w3.org/TR/service-workers/#dom-installevent-addroutes, not supported everywhere */
  addRoutes?(rules: object): Promise<void>;
}

interface FetchEvent extends Event {
  readonly request: Request;
  readonly preloadResponse: Promise<Response | undefined>;
  respondWith(response: Promise<Response>): void;
}

interface Worker {
  readonly registration: ServiceWorkerRegistration;
  skipWaiting(): Promise<void>;
  addEventListener(type: 'install' | 'activate', handle: (event: LifeEvent) => void): void;
  addEventListener(type: 'fetch', handle: (event: FetchEvent) => void): void;
}

const worker = self as unknown as Worker;

worker.addEventListener('install', (event) => {
  void worker.skipWaiting();
  // Where supported, the browser bypasses this worker except for navigation.
  const others = { condition: { not: { requestMode: 'navigate' } }, source: 'network' };
  event.waitUntil(Promise.resolve(event.addRoutes?.(others)).catch(() => undefined));
});

worker.addEventListener('activate', (event) => {
  // The request is sent while this worker is still starting.
  event.waitUntil(Promise.resolve(worker.registration.navigationPreload?.enable()));
});

worker.addEventListener('fetch', (event) => {
  if (event.request.mode === 'navigate') event.respondWith(load(event));
});

async function load({ request, preloadResponse }: FetchEvent): Promise<Response> {
  try {
    return (await preloadResponse) ?? (await fetch(request));
  } catch {
    return outOfReach();
  }
}

function outOfReach(): Response {
  const nonce = crypto.randomUUID();
  const body = page.replace('/* style */', () => style).replace('nonce=""', `nonce="${nonce}"`);
  return new Response(body, {
    status: 503,
    headers: {
      'content-type': 'text/html; charset=utf-8',
      'cache-control': 'no-store',
      'content-security-policy': `default-src 'none'; style-src 'unsafe-inline'; script-src 'nonce-${nonce}'; connect-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'`,
    },
  });
}
