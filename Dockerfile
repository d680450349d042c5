# docker build -t tsim .
# docker run --rm -v "$PWD:/work" tsim -in in.heap        the folder with the script is /work in the container
# docker run --rm -it --entrypoint python3 -v "$PWD:/work" tsim
FROM debian:bookworm-slim AS build
RUN apt-get update && apt-get install -y --no-install-recommends gcc make autoconf automake pkg-config libgsl-dev \
	zlib1g-dev libpng-dev libhdf5-dev && rm -rf /var/lib/apt/lists/*
COPY . /source
RUN cd /source && { [ -x configure ] || ./bootstrap; } && mkdir -p /build && cd /build && \
	/source/configure --prefix=/usr/local && make -j"$(nproc)" && make install DESTDIR=/made && \
	rm /made/usr/local/lib/libtsim.a && strip --strip-debug /made/usr/local/bin/tsim /made/usr/local/lib/libtsim.so.0.*

FROM debian:bookworm-slim
RUN apt-get update && apt-get install -y --no-install-recommends libgsl27 zlib1g libpng16-16 libhdf5-103-1 libgomp1 ffmpeg \
	python3 python3-numpy python3-pandas && rm -rf /var/lib/apt/lists/*
COPY --from=build /made/usr/local /usr/local
COPY --from=build /source/examples /usr/local/share/tsim/examples
RUN ldconfig && tsim -version
ENV PYTHONPATH=/usr/local/share/tsim/python
WORKDIR /work
ENTRYPOINT ["tsim"]
