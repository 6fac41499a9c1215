/** The code of a seat in the address, such as `#take=7KRM`: from the QR code of the phone that hands over. */
export function takeCodeOf(hash: string): string | undefined {
  const code = new URLSearchParams(hash.replace(/^#/, '')).get('take');
  return code ? toCode(code) : undefined;
}

/** As it is read aloud: capitals, without spaces. */
export function toCode(text: string): string {
  return text.toUpperCase().replace(/[^A-Z0-9]/g, '');
}

/** The address that another phone opens to take over a seat. */
export function takeAddressOf(code: string, page: string): string {
  return new URL(`/party/play#take=${encodeURIComponent(code)}`, page).href;
}
