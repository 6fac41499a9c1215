/** A QR code for a terminal, in its own colours: dark on light whatever the theme. */
export async function formatQrCode(text: string): Promise<string> {
  // Needed once, and by few: not worth the time at every start.
  const { default: qrcode } = await import('qrcode');
  return qrcode.toString(text, { type: 'terminal', small: true, errorCorrectionLevel: 'M' });
}
