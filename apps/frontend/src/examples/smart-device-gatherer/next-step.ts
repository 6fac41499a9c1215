/** What the page knows of the phones. */
interface Gathered {
  readonly phones: number;
  readonly touches: number;
  readonly isRunning: boolean;
}

/** What people do next, one sentence; undefined when nothing has to be said. */
export function nextStep({ phones, touches, isRunning }: Gathered): string | undefined {
  if (phones === 0) return undefined;
  if (phones === 1) return 'Connect a second phone: two phones with near touches vibrate.';
  if (touches > 0) return undefined;
  return isRunning
    ? 'Touch the pads of two phones at the same place.'
    : 'Start the session, then touch the pads of two phones at the same place.';
}
